// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/node.h"

namespace sphinx::input {

/// JSON text of a tree, its keys in the order of the tree, with a newline at the end. Plain scalars
/// that are JSON numbers or true, false, null become these, all others strings.
std::string writeJson(const Node& node);

}  // namespace sphinx::input
