// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace sphinx::io {

/// Appends text with the characters escaped that XML gives a meaning or that a reader may change
/// (tab, carriage return). Line feeds stay: attributes must not hold any.
void appendEscaped(std::string& to, std::string_view text);
std::string escaped(std::string_view text);

/// True if XML 1.0 can say it: valid UTF-8 without control characters other than tab, line feed
/// and carriage return.
bool isXmlText(std::string_view text);

}  // namespace sphinx::io
