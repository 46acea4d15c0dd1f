// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace sphinx::io {

/// Builds binary records of little-endian numbers.
class LittleEndian {
 public:
    LittleEndian& u8(std::uint8_t value) { return number(value, 1); }
    LittleEndian& u16(std::uint16_t value) { return number(value, 2); }
    LittleEndian& u32(std::uint32_t value) { return number(value, 4); }
    LittleEndian& u64(std::uint64_t value) { return number(value, 8); }
    LittleEndian& bytes(std::initializer_list<std::uint8_t> values) {
        for (const std::uint8_t value : values) u8(value);
        return *this;
    }
    LittleEndian& text(std::string_view value) {
        bytes_ += value;
        return *this;
    }
    std::string take() { return std::move(bytes_); }

 private:
    LittleEndian& number(std::uint64_t value, int size) {
        for (int k = 0; k < size; ++k) bytes_ += static_cast<char>(value >> (8 * k) & 0xff);
        return *this;
    }

    std::string bytes_;
};

}  // namespace sphinx::io
