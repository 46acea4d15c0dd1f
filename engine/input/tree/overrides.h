// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/diagnostics.h"
#include "input/tree/node.h"

#include <string>
#include <vector>

namespace sphinx::input {

/// Applies the values of --set, "path=YAML", to a case. A path is keys joined by dots; in a list a
/// layer is found by its name and any item by its number from 0. Entries of `named_blocks`
/// (variables, bodies, ...) must exist already: a misspelt one would otherwise become a new entry.
void applyOverrides(Node& root, const std::vector<std::string>& overrides,
                    const std::vector<std::string>& named_blocks, int source_order,
                    Diagnostics& diagnostics);

}  // namespace sphinx::input
