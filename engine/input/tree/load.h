// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/diagnostics.h"
#include "input/tree/node.h"

#include <string>
#include <vector>

namespace sphinx::input {

struct LoadedCase {
    Node root;
    std::vector<std::string> files;  ///< the case file and those that it includes
};

/// The map of a whole case: the file, what it includes (maps merge by key, the including file wins,
/// lists replace), and the overrides "path=YAML" of --set. `named_blocks` are the blocks whose keys
/// the author chooses: --set changes entries there but adds none. What is wrong is reported.
LoadedCase loadCase(const std::string& path, const std::vector<std::string>& overrides,
                    const std::vector<std::string>& named_blocks, Diagnostics& diagnostics);

/// The same for a text that is already in memory, shown as `name` in messages.
LoadedCase loadText(std::string name, std::string text, const std::vector<std::string>& overrides,
                    const std::vector<std::string>& named_blocks, Diagnostics& diagnostics);

}  // namespace sphinx::input
