// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/restart/restart.h"
#include "io/xml/reader.h"

#include <functional>

namespace sphinx::io {

/// Values of one field in a restart: pieces like <zlib values="65536" crc32="0a1b2c3d">... or
/// <text ...>; the checksum is that of the values in memory.
inline constexpr std::size_t values_in_piece = 65536;

/// The piece for at most values_in_piece 64-bit values.
std::string encodePiece(const char* values, std::size_t count, bool integers,
                        RestartEncoding encoding);

/// Reads the piece whose start tag was just read and appends its values.
void appendPiece(XmlReader& reader, const XmlElement& element, bool integers,
                 AlignedVector<std::int64_t>& bits);

}  // namespace sphinx::io
