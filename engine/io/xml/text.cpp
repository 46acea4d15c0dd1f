// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/xml/text.h"

#include "core/characters.h"

namespace sphinx::io {

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
