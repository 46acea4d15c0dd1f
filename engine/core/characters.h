// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace sphinx {

/// What some editors put at the start of a file in UTF-8; it is no part of the text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Length of the UTF-8 sequence at the start of text (not empty) that stands for a character of XML
/// 1.0, else 0: no control characters but tab, line feed and carriage return, no surrogates, no
/// overlong forms, nothing beyond U+10FFFF.
std::size_t characterLength(std::string_view text);

/// Consists of such characters, and of none that a terminal may take for a command (DEL, and the
/// controls from U+0080 on).
bool isPlainText(std::string_view text);

}  // namespace sphinx
