// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/tree/suggest.h"

#include <algorithm>

namespace sphinx::input {

std::size_t editDistance(std::string_view a, std::string_view b) {
    // Rows of the Damerau-Levenshtein table (optimal string alignment).
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + cost});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

bool isNear(std::string_view wrong, std::string_view name) {
    const std::size_t most = 1 + wrong.size() / 5;
    const std::size_t difference =
        name.size() > wrong.size() ? name.size() - wrong.size() : wrong.size() - name.size();
    if (difference > most) return false;
    const std::size_t distance = editDistance(wrong, name);
    return distance <= most && distance < wrong.size();
}

std::optional<std::string> nearest(std::string_view wrong, const std::vector<std::string>& known) {
    const std::string* best = nullptr;
    for (const std::string& name : known) {
        // "acoustic_time_step" without its family is a near miss too.
        if (name.size() > wrong.size() && name.ends_with(wrong) &&
            name[name.size() - wrong.size() - 1] == '.')
            return name;
        if (isNear(wrong, name) &&
            (!best || editDistance(wrong, name) < editDistance(wrong, *best)))
            best = &name;
    }
    if (best) return *best;
    // The beginning of one name alone: "wendland" for "wendland_c2".
    const auto begins = [&](const std::string& name) {
        return wrong.size() >= 3 && name.starts_with(wrong);
    };
    const auto begun = std::find_if(known.begin(), known.end(), begins);
    if (begun == known.end() || std::find_if(begun + 1, known.end(), begins) != known.end())
        return std::nullopt;
    return *begun;
}

std::string didYouMean(std::string_view wrong, const std::vector<std::string>& known) {
    if (known.empty()) return "";
    if (const auto near = nearest(wrong, known)) return "; did you mean '" + *near + "'?";
    return "; known: " + joined(known);
}

std::string mapOfKeys(const std::vector<std::string>& keys) {
    return "a map; its keys: " + joined(keys);
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string alternatives(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) text += k + 1 == words.size() ? " or " : ", ";
        text += words[k];
    }
    return text;
}

std::string withArticle(const std::string& words) {
    const bool vowel = words.find_first_of("aeio") == 0;
    return (vowel ? "an " : "a ") + words;
}

}  // namespace sphinx::input
