// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/place.h"

#include <tuple>

namespace sphinx::input {

std::string_view Source::line(int number) const {
    std::string_view rest = text;
    for (int k = 1; k < number; ++k) {
        const auto end = rest.find('\n');
        if (end == std::string_view::npos) return {};
        rest.remove_prefix(end + 1);
    }
    rest = rest.substr(0, rest.find('\n'));
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    return rest;
}

std::string Place::origin() const {
    if (!source) return "default";
    if (source->name == "--set") return source->name;
    return source->name + ":" + std::to_string(line);
}

bool operator<(const Place& a, const Place& b) {
    const auto key = [](const Place& p) {
        return std::tuple(p.source ? p.source->order : -1, p.line, p.column);
    };
    return key(a) < key(b);
}

}  // namespace sphinx::input
