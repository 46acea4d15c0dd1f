// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/characters.h"

namespace sphinx {

std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(0);
    if (first < 0x80)
        return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    unsigned code = first & (0x7f >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte(k) & 0x3f);
    }
    const unsigned smallest = length == 4 ? 0x10000 : length == 3 ? 0x800 : 0x80;
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < smallest || code > 0x10ffff || surrogate || code == 0xfffe || code == 0xffff)
        return 0;
    return length;
}

bool isPlainText(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        const auto second = static_cast<unsigned char>(length > 1 ? text[1] : 0);
        const bool control = text[0] == '\x7f' || (text[0] == '\xc2' && second < 0xa0);
        if (length == 0 || control) return false;
        text.remove_prefix(length);
    }
    return true;
}

}  // namespace sphinx
