// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/hdf5/checksum.h"

#include <bit>

namespace sphinx::io::hdf5 {

std::uint32_t metadataChecksum(std::string_view bytes) {
    std::uint32_t a = 0xdeadbeef + static_cast<std::uint32_t>(bytes.size());
    std::uint32_t b = a;
    std::uint32_t c = a;
    const auto take = [](std::string_view from, std::size_t at) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 4 && at + k < from.size(); ++k)
            word |= std::uint32_t{static_cast<unsigned char>(from[at + k])} << (8 * k);
        return word;
    };
    while (bytes.size() > 12) {
        a += take(bytes, 0);
        b += take(bytes, 4);
        c += take(bytes, 8);
        a = (a - c) ^ std::rotl(c, 4), c += b;
        b = (b - a) ^ std::rotl(a, 6), a += c;
        c = (c - b) ^ std::rotl(b, 8), b += a;
        a = (a - c) ^ std::rotl(c, 16), c += b;
        b = (b - a) ^ std::rotl(a, 19), a += c;
        c = (c - b) ^ std::rotl(b, 4), b += a;
        bytes.remove_prefix(12);
    }
    if (bytes.empty()) return c;
    a += take(bytes, 0);
    b += take(bytes, 4);
    c += take(bytes, 8);
    c = (c ^ b) - std::rotl(b, 14);
    a = (a ^ c) - std::rotl(c, 11);
    b = (b ^ a) - std::rotl(a, 25);
    c = (c ^ b) - std::rotl(b, 16);
    a = (a ^ c) - std::rotl(c, 4);
    b = (b ^ a) - std::rotl(a, 14);
    return (c ^ b) - std::rotl(b, 24);
}

}  // namespace sphinx::io::hdf5
