// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/yaml_traps.h"

#include "core/characters.h"

#include <algorithm>

namespace sphinx::input {
namespace {

constexpr std::size_t largest_text = 4'000'000;
constexpr std::size_t longest_line = 100'000;

int parenthesisBalance(std::string_view text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '(') -
                            std::count(text.begin(), text.end(), ')'));
}

std::string_view wordAt(std::string_view text, std::size_t position) {
    const std::size_t end = text.find_first_of(" \t\r\n,[]{}", position);
    return text.substr(position, std::min(end, text.size()) - position).substr(0, 60);
}

/// In the line at that position, or the one before: the start of "key:value" without a blank.
std::optional<std::size_t> blankMissing(std::string_view text, std::size_t position) {
    const auto lineStart = [&](std::size_t k) {
        const auto end = k == 0 ? std::string_view::npos : text.rfind('\n', k - 1);
        return end == std::string_view::npos ? 0 : end + 1;
    };
    std::size_t begin = lineStart(position);
    for (int lines = 0; lines < 2; ++lines) {
        const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
        const std::size_t word = line.find_first_not_of(" -");
        const std::size_t colon = line.find(':');
        if (word != std::string_view::npos && colon != std::string_view::npos && colon > word &&
            colon + 1 < line.size() && line[colon + 1] != ' ' &&
            line.substr(word, colon - word).find_first_of(" '\"{[#") == std::string_view::npos)
            return begin + word;
        if (begin == 0) break;
        begin = lineStart(begin - 1);
    }
    return std::nullopt;
}

}  // namespace

bool checkText(const std::shared_ptr<const Source>& source, std::string_view text, Offset offset,
               Diagnostics& diagnostics) {
    const auto refuse = [&](int line, std::size_t column, std::string message) {
        diagnostics.error({source, line + offset.line, static_cast<int>(column) + 1},
                          std::move(message));
        return false;
    };
    if (text.size() > largest_text)
        return refuse(-offset.line, 0,
                      "the file has " + std::to_string(text.size()) +
                          " bytes; a case has at most " + std::to_string(largest_text) +
                          " (put long lists into files)");
    int line = 1;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end - begin > longest_line)
            return refuse(line, 0,
                          "the line has " + std::to_string(end - begin) + " bytes; at most " +
                              std::to_string(longest_line) +
                              " are read (put long lists into files)");
        bool indentation = true;
        int column = 1;  // in characters
        for (std::size_t k = begin; k < end; ++column) {
            const std::size_t length = characterLength(text.substr(k, end - k));
            const char c = text[k];
            if (length == 0)
                return refuse(-offset.line, 0,
                              "this is not a text file: byte " + std::to_string(k) + " (line " +
                                  std::to_string(line) + ", column " + std::to_string(column) +
                                  ") is not UTF-8 text");
            if (c == '\t' && indentation)
                return refuse(line, k - begin, "a tab in the indentation; YAML wants blanks");
            indentation = indentation && c == ' ';
            k += length;
        }
        begin = end + 1;
    }
    return true;
}

Explanation explainSyntaxError(std::string_view text, std::size_t position,
                               const std::string& message, std::optional<std::size_t> open) {
    position = std::min(position, text.size());
    const std::string word(wordAt(text, position));
    const std::string first(text.substr(position, 1));
    const auto here = [&](std::string explained) {
        return Explanation{position, std::move(explained)};
    };
    if (message == "the referenced anchor is not defined" || message == "alias not found after *")
        return here("'" + word +
                    "' is an alias of YAML and nothing defines it; put an expression that starts "
                    "with * into quotes");
    if (message == "illegal map value") {
        if (const auto slip = blankMissing(text, position)) {
            const std::string pair(text.substr(*slip, text.find_first_of("\r\n", *slip) - *slip));
            const auto colon = pair.find(':');
            return {*slip, "a blank is missing after the colon: '" + pair.substr(0, colon) + ": " +
                               pair.substr(colon + 1) + "'"};
        }
        return here(
            "unexpected colon; put a value that contains ': ' or '? :' into quotes, and "
            "check the indentation");
    }
    if (message.starts_with("end of map flow") || message.starts_with("end of sequence flow")) {
        if (first == "?" || (first == ":" && text.substr(0, position).ends_with('?')))
            return here("put an expression with '? :' into quotes");
        const char bracket = message.starts_with("end of map") ? '}' : ']';
        const bool other_line =
            open && text.substr(*open, position - *open).find('\n') != std::string_view::npos;
        if (open && (other_line || position + 1 >= text.size() || position <= *open))
            return {*open, "'" + std::string(text.substr(*open, 1)) + "' is never closed"};
        return here(std::string("expected a comma or ") + bracket + " before this");
    }
    if (message == "illegal flow end")
        return here("nothing was opened that '" + first + "' could close");
    if (message.starts_with("end of map not found") ||
        message.starts_with("end of sequence not found"))
        return here("'" + word + "' does not belong here; check indentation and quotes");
    if (message == "unknown token")
        return here("a value cannot start with '" + first + "'; put it into quotes");
    return here(message);
}

void findSplitExpressions(const Node& node, Diagnostics& diagnostics) {
    if (!node.flow) return;
    // The plain texts of the collection in the order written; the comma stood between them.
    struct Piece {
        const std::string* text;
        const Place* place;
    };
    std::vector<Piece> pieces;
    for (const Node& item : node.items)
        if (item.isScalar() && !item.quoted) pieces.push_back({&item.text, &item.place});
    for (const Node::Entry& entry : node.entries) {
        if (entry.value.isScalar() && !entry.value.quoted)
            pieces.push_back({&entry.value.text, &entry.value.place});
        if (!entry.value.isNull()) continue;
        pieces.push_back({&entry.key, &entry.place});
        const auto colon = entry.key.find(':');
        if (colon != std::string::npos && parenthesisBalance(entry.key) == 0)
            diagnostics.error(entry.place, "a blank is missing after the colon: '" +
                                               entry.key.substr(0, colon) + ": " +
                                               entry.key.substr(colon + 1) + "'");
    }
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
        if (parenthesisBalance(*pieces[k].text) <= 0) continue;
        std::string whole = *pieces[k].text;
        for (std::size_t next = k + 1; next < pieces.size(); ++next) {
            whole += ", " + *pieces[next].text;
            if (parenthesisBalance(whole) > 0) continue;
            diagnostics.error(*pieces[k].place,
                              "a comma inside [...] or {...} ends the value; put the expression "
                              "into quotes: \"" +
                                  whole + "\"");
            k = next;
            break;
        }
    }
}

bool quoteIsClosed(std::string_view text, std::size_t position) {
    if (position >= text.size() || (text[position] != '"' && text[position] != '\'')) return true;
    const char quote = text[position];
    for (std::size_t k = position + 1; k < text.size(); ++k) {
        if (quote == '"' && text[k] == '\\') {
            ++k;
        } else if (text[k] == quote) {
            if (quote == '"' || k + 1 >= text.size() || text[k + 1] != quote) return true;
            ++k;
        }
    }
    return false;
}

}  // namespace sphinx::input
