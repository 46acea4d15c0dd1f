// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sphinx::input {

/// What declarations, and comments in the sources, cite by a short key: "guide (54)" is equation
/// 54 of the publication "guide".
struct Publication {
    std::string_view key;   ///< "guide", or authors and year
    std::string_view text;  ///< authors, title, where it appeared, year
    std::string_view doi;   ///< empty: it has none
};

/// The one list of all of them, sorted by key.
std::span<const Publication> publications();
/// nullptr when there is none of that key.
const Publication* findPublication(std::string_view key);
/// Text and doi.
std::string fullCitation(const Publication& publication);

}  // namespace sphinx::input
