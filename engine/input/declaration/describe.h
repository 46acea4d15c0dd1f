// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

#include <string>

namespace sphinx::input {

/// The names of a kind, or of all kinds when `kind` is empty, one a line with its summary.
/// Throws CaseError for a wrong kind.
std::string listText(const Registry& registry, const std::string& kind);

/// Everything a declaration says, for the terminal; else the keys of that name and where they
/// stand; else what speaks of that word. Throws CaseError where nothing does.
std::string describeText(const Registry& registry, const std::string& name);

/// The reference page of the language: every declaration, units and expressions, as Markdown.
std::string referencePage(const Registry& registry);

}  // namespace sphinx::input
