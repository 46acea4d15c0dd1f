// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/schema.h"
#include "input/expressions/decimal.h"

#include <fmt/format.h>

namespace sphinx::input {
namespace {

std::string jsonString(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        else
            out += c;
    }
    return out + "\"";
}

bool isLiteral(const Node& node) {
    return !node.quoted && (parseDecimal<double>(node.text) || node.text == "true" ||
                            node.text == "false" || node.text == "null");
}

void write(const Node& node, int indent, std::string& out) {
    const std::string margin(indent + 2, ' ');
    const auto close = [&](char bracket) { out += "\n" + std::string(indent, ' ') + bracket; };
    if (node.isNull()) {
        out += "null";
    } else if (node.isScalar()) {
        out += isLiteral(node) ? node.text : jsonString(node.text);
    } else if (node.isList()) {
        bool short_list = true;
        for (const Node& item : node.items) short_list = short_list && item.isScalar();
        out += "[";
        for (std::size_t k = 0; k < node.items.size(); ++k) {
            if (k > 0) out += short_list ? ", " : ",";
            if (!short_list) out += "\n" + margin;
            write(node.items[k], indent + 2, out);
        }
        if (short_list)
            out += "]";
        else
            close(']');
    } else {
        out += "{";
        for (std::size_t k = 0; k < node.entries.size(); ++k) {
            out += (k > 0 ? ",\n" : "\n") + margin + jsonString(node.entries[k].key) + ": ";
            write(node.entries[k].value, indent + 2, out);
        }
        if (node.entries.empty())
            out += "}";
        else
            close('}');
    }
}

}  // namespace

std::string toJson(const Node& node) {
    std::string out;
    write(node, 0, out);
    return out + "\n";
}

}  // namespace sphinx::input
