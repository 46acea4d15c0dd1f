// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/xml/text.h"

namespace sphinx::io {
namespace {

/// Length of the UTF-8 sequence at the start of text that stands for a character of XML, else 0.
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

}  // namespace

void appendEscaped(std::string& to, std::string_view text) {
    for (const char c : text) {
        switch (c) {
            case '&': to += "&amp;"; break;
            case '<': to += "&lt;"; break;
            case '>': to += "&gt;"; break;
            case '"': to += "&quot;"; break;
            case '\t': to += "&#9;"; break;
            case '\r': to += "&#13;"; break;
            default: to += c;
        }
    }
}

std::string escaped(std::string_view text) {
    std::string result;
    appendEscaped(result, text);
    return result;
}

bool isXmlText(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

}  // namespace sphinx::io
