// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::input {

/// Edit distance with insertion, deletion, replacement and exchange of neighbors.
std::size_t editDistance(std::string_view a, std::string_view b);

/// True when `name` may be what `wrong` was meant to be: distance at most 1 + length/5.
bool isNear(std::string_view wrong, std::string_view name);

/// The known name that `wrong` may have been meant to be; nothing when none is near.
std::optional<std::string> nearest(std::string_view wrong, const std::vector<std::string>& known);

/// End of a message about a wrong name: "; did you mean 'wall'?" when one is near, else "; known:
/// gate, wall, water"; empty when there is nothing to choose from.
std::string didYouMean(std::string_view wrong, const std::vector<std::string>& known);

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& words);
/// "a wall", "an elastic body"; words that begin with u as in "unit" or "user".
std::string withArticle(const std::string& words);
/// "a map; its keys: a, b, c"
std::string mapOfKeys(const std::vector<std::string>& keys);
/// "a, b, c"
std::string joined(const std::vector<std::string>& words);

}  // namespace sphinx::input
