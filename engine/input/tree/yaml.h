// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/tree/diagnostics.h"
#include "input/tree/node.h"

namespace sphinx::input {

/// Where a text stands when it is only a piece of its source: the value of a --set.
struct Offset {
    int line = 0;    ///< added to lines
    int column = 0;  ///< added to columns of the first line
};

/// The tree of one YAML document, every value with its place. Stricter than YAML: no duplicate
/// keys, merge keys, tags or keys that are not text; and what YAML takes for something else than
/// the author meant is explained. Size, depth and aliases are limited. What is wrong is reported;
/// the result is then incomplete.
Node readYaml(const std::shared_ptr<const Source>& source, std::string_view text, Offset offset,
              Diagnostics& diagnostics);

/// Readable YAML of a tree; every line that holds a value ends with the value's origin as a
/// comment when `origins` is set.
std::string writeYaml(const Node& node, bool origins);

}  // namespace sphinx::input
