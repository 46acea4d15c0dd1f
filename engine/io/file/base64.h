// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sphinx::io {

/// RFC 4648, padded, without line breaks.
std::string encodeBase64(std::string_view bytes);
/// Nothing if the text is not exactly what encodeBase64 makes of some bytes.
std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace sphinx::io
