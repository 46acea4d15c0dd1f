// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sphinx::io {

/// A zlib stream of the bytes. Pieces that look like noise (the low bits of floating-point
/// numbers) are stored as they are inside the stream: deflating them costs ten times the time and
/// saves a few percent. The result depends on the bytes alone.
std::string compress(std::string_view bytes);

/// Inflates a stream that must hold exactly `size` bytes; false if it does not or is damaged.
bool decompress(std::string_view stream, char* to, std::size_t size);

/// CRC-32 of the bytes, continued from `previous`.
std::uint32_t checksum(std::string_view bytes, std::uint32_t previous = 0);

/// 64 bits that tell whether an array is the same as in the frame before.
std::uint64_t fingerprint(std::string_view bytes);

}  // namespace sphinx::io
