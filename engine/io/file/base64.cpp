// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/file/base64.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace sphinx::io {
namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_digit = 255;

constexpr std::array<std::uint8_t, 256> makeValues() {
    std::array<std::uint8_t, 256> values{};
    values.fill(no_digit);
    for (std::size_t k = 0; k < digits.size(); ++k)
        values[static_cast<unsigned char>(digits[k])] = static_cast<std::uint8_t>(k);
    return values;
}
constexpr std::array<std::uint8_t, 256> values = makeValues();

/// Two digits for every 12 bits.
constexpr std::array<std::array<char, 2>, 4096> makePairs() {
    std::array<std::array<char, 2>, 4096> pairs{};
    for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k] = {digits[k >> 6], digits[k & 63]};
    return pairs;
}
constexpr std::array<std::array<char, 2>, 4096> pairs = makePairs();

}  // namespace

std::string encodeBase64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    const auto byte = [&](std::size_t k) { return unsigned{static_cast<unsigned char>(bytes[k])}; };
    char* out = text.data();
    const std::size_t whole = bytes.size() / 3 * 3;
    for (std::size_t k = 0; k < whole; k += 3, out += 4) {
        const unsigned group = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
        std::memcpy(out, pairs[group >> 12].data(), 2);
        std::memcpy(out + 2, pairs[group & 4095].data(), 2);
    }
    if (whole == bytes.size()) return text;
    const bool two = whole + 2 == bytes.size();
    const unsigned group = byte(whole) << 16 | (two ? byte(whole + 1) << 8 : 0);
    for (std::size_t d = 0; d < (two ? 3u : 2u); ++d) out[d] = digits[group >> (18 - 6 * d) & 63];
    return text;
}

std::optional<std::string> decodeBase64(std::string_view text) {
    if (text.size() % 4 != 0) return {};
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=')
        ++padding;
    const std::size_t digit_count = text.size() - padding;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t group = 0;
    unsigned bits = 0;
    for (const char c : text.substr(0, digit_count)) {
        const std::uint8_t value = values[static_cast<unsigned char>(c)];
        if (value == no_digit) return {};
        group = group << 6 | value;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(group >> bits & 255);
        }
    }
    // Bits that belong to no byte must be zero: one text for one value.
    if ((group & ((1u << bits) - 1)) != 0) return {};
    return bytes;
}

}  // namespace sphinx::io
