// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/expressions/decimal.h"
#include "input/tree/yaml.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace sphinx::input {
namespace {

constexpr std::size_t widest_line = 90;
constexpr std::size_t comment_column = 48;

/// True when the text reads back as the same plain scalar, in block and flow style.
bool isPlainSafe(const std::string& text) {
    static constexpr std::string_view first =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./(";
    if (text.empty() || text.back() == ' ' || text.back() == ':') return false;
    const bool sign =
        text.size() > 1 && (text[0] == '-' || text[0] == '+') && text[1] != ' ' && text[1] != '-';
    if (!sign && first.find(text[0]) == std::string_view::npos) return false;
    if (text == "..." || text.starts_with("... ")) return false;
    if (text.find(": ") != std::string::npos || text.find(" #") != std::string::npos) return false;
    return std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ||
               std::string_view(",[]{}\"'").find(c) != std::string_view::npos;
    });
}

bool looksLikeValue(const std::string& text) {
    static constexpr std::array words{"true", "false", "null", "~",    "yes",
                                      "no",   "on",    "off",  "Null", "NULL"};
    return parseDecimal<double>(text) || std::find(words.begin(), words.end(), text) != words.end();
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else if (c == '\n')
            out += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        else
            out += c;
    }
    return out + "\"";
}

std::string scalarText(const Node& node) {
    const bool plain = isPlainSafe(node.text) && !(node.quoted && looksLikeValue(node.text));
    return plain ? node.text : quoted(node.text);
}

/// Lists of scalars, and lists of those, fit on one line.
std::string flow(const Node& node) {
    if (node.isNull()) return "null";
    if (node.isScalar()) return scalarText(node);
    std::string out;
    for (const Node& item : node.items) out += (out.empty() ? "" : ", ") + flow(item);
    return "[" + out + "]";
}

bool hasMap(const Node& node) {
    return node.isMap() || std::any_of(node.items.begin(), node.items.end(), hasMap);
}

class Writer {
 public:
    explicit Writer(bool origins) : origins_(origins) {}

    /// Writes what follows `head`, which stands on the current line already ("  key:" or "  -").
    void value(std::string head, const Node& node, int indent) {
        if (node.isMap() && !node.entries.empty()) {
            out += head + "\n";
            map(node, indent, false);
            return;
        }
        if (node.isMap()) return line(head + " {}", node);
        const bool inline_list = !node.isList() || (!hasMap(node) && fits(head, node));
        if (inline_list) return line(head + " " + flow(node), node);
        out += head + "\n";
        list(node, indent);
    }

    void map(const Node& node, int indent, bool first_is_placed) {
        for (const Node::Entry& entry : node.entries) {
            const std::string margin = first_is_placed ? "" : std::string(indent, ' ');
            first_is_placed = false;
            value(margin + (isPlainSafe(entry.key) ? entry.key : quoted(entry.key)) + ":",
                  entry.value, indent + 2);
        }
    }

    std::string out;

 private:
    static bool fits(const std::string& head, const Node& list) {
        return list.items.size() < widest_line && head.size() + flow(list).size() < widest_line;
    }

    void list(const Node& node, int indent) {
        for (const Node& item : node.items) {
            const std::string dash = std::string(indent, ' ') + "-";
            if (item.isMap() && !item.entries.empty()) {
                out += dash + " ";
                map(item, indent + 2, true);
            } else {
                value(dash, item, indent + 2);
            }
        }
    }

    void line(std::string text, const Node& node) {
        if (origins_) {
            const auto begin = out.rfind('\n');
            const std::size_t placed = out.size() - (begin == std::string::npos ? 0 : begin + 1);
            const std::size_t width = placed + text.size();
            text += std::string(width < comment_column ? comment_column - width : 1, ' ') + " # " +
                    node.place.origin();
        }
        out += text + "\n";
    }

    bool origins_;
};

}  // namespace

std::string writeYaml(const Node& node, bool origins) {
    Writer writer(origins);
    writer.map(node, 0, false);
    return std::move(writer.out);
}

}  // namespace sphinx::input
