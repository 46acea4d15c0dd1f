// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/facts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace sphinx::loop {

/// An accumulated field and the place where its layer sets it to zero.
struct Zeroing {
    std::string body;
    std::string field;
    std::size_t before = 0;  ///< index of a step of the layer, as in the facts
};

/// Fields that the calls of this layer accumulate (not those of layers inside it), each with its
/// first accumulator; ascending by `before`.
std::vector<Zeroing> zeroings(const Layer& layer);

}  // namespace sphinx::loop
