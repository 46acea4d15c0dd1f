// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/diagnostics.h"

#include "core/errors.h"

#include <algorithm>

namespace sphinx::input {
namespace {

constexpr std::size_t most_messages = 50;
constexpr std::size_t widest_shown = 200;  // bytes of a source line that a message shows

bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), startsCharacter));
}

/// The source line and a caret below the column; of a very long line the part around it.
std::string excerpt(const Place& place) {
    std::string_view line = place.source->line(place.line);
    std::size_t column = std::min<std::size_t>(place.column - 1, line.size());
    std::string before;
    std::string after;
    if (line.size() > widest_shown) {
        std::size_t begin = column > widest_shown / 2 ? column - widest_shown / 2 : 0;
        while (begin > 0 && !startsCharacter(line[begin])) --begin;
        std::size_t end = std::min(line.size(), begin + widest_shown);
        while (end < line.size() && !startsCharacter(line[end])) ++end;
        if (begin > 0) before = "...";
        if (end < line.size()) after = "...";
        line = line.substr(begin, end - begin);
        column -= begin;
    }
    std::string shown = "  " + before;
    std::string caret(shown.size(), ' ');
    for (std::size_t k = 0; k < line.size(); ++k) {
        const auto c = static_cast<unsigned char>(line[k]);
        shown += c < 0x20 && c != '\t' ? '?' : line[k];
        if (k < column && startsCharacter(line[k])) caret += c == '\t' ? '\t' : ' ';
    }
    return shown + after + "\n" + caret + "^\n";
}

}  // namespace

void Diagnostics::error(const Place& place, std::string message) {
    entries_.push_back({true, place, std::move(message)});
    ++errors_;
}

void Diagnostics::warning(const Place& place, std::string message) {
    entries_.push_back({false, place, std::move(message)});
}

std::string Diagnostics::text() const {
    std::vector<const Entry*> sorted;
    for (const Entry& entry : entries_) sorted.push_back(&entry);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Entry* a, const Entry* b) { return a->place < b->place; });
    std::string out;
    std::size_t shown = 0;
    const Entry* last = nullptr;
    for (const Entry* entry : sorted) {
        // A value that an alias repeats is wrong in one place only.
        if (last && !(last->place < entry->place) && last->message == entry->message) continue;
        last = entry;
        if (shown++ == most_messages) {
            out += "... and " + std::to_string(sorted.size() - most_messages) + " more\n";
            break;
        }
        const Place& place = entry->place;
        if (place.source && place.line > 0) {
            const std::string_view line = place.source->line(place.line);
            const std::size_t column = std::min<std::size_t>(place.column - 1, line.size());
            out += place.source->name + ":" + std::to_string(place.line) + ":" +
                   std::to_string(characters(line.substr(0, column)) + 1) + ": ";
        } else if (place.source) {
            out += place.source->name + ": ";
        }
        out += (entry->is_error ? "error: " : "warning: ") + entry->message + "\n";
        if (place.source && place.line > 0) out += excerpt(place);
    }
    return out;
}

void Diagnostics::throwIfErrors() const {
    if (!hasErrors()) return;
    std::string all = text();
    all.pop_back();  // the message of an exception carries no last newline
    throw CaseError(all);
}

}  // namespace sphinx::input
