// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace sphinx::language {

/// The version of the language that this program speaks: `sphinx: 2` in a case. It rises when an
/// unchanged case would give another result than before; a new key or method leaves it as it is.
inline constexpr int language_version = 2;

/// What an unchanged case means since a version that it did not mean before.
struct LanguageChange {
    int version = 0;
    /// Whether the state of a run is another one, and not only what is written of it.
    bool of_state = false;
    /// The places of a case that it concerns; none where the case means the same as before.
    std::function<std::vector<input::Place>(const model::Case&)> concerns;
    std::string text;  ///< goes on after "since version N of the language "
};

/// All of them, from the oldest on; schemas/CHANGES.md lists them in the same words.
std::span<const LanguageChange> languageChanges();

/// Warns of a place that means something else since that version: "since version N of the language
/// TEXT", and what to do.
void warnChange(const input::Place& place, int version, const std::string& text,
                input::Diagnostics& diagnostics);

/// Warns a case of an older version of each place that means something else now.
void warnChanges(const model::Case& model, int version, std::span<const LanguageChange> changes,
                 input::Diagnostics& diagnostics);

/// The version since which the case means the same state: that of the newest change of the state
/// that concerns it. A restart of an older program that says the same goes on.
int stateVersion(const model::Case& model, std::span<const LanguageChange> changes);

}  // namespace sphinx::language
