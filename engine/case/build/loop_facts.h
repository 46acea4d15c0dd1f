// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/tree/diagnostics.h"
#include "loop/flow/facts.h"

namespace sphinx::build {

/// The loop of a case as it is written, with the places that its ids stand for.
struct PlacedFacts {
    loop::LoopFacts facts;
    std::vector<input::Place> places;  ///< by id
};

PlacedFacts loopFacts(const model::Case& model);

/// The trigger of an `every`; nothing for the start and the end only.
std::optional<loop::Trigger> triggerOf(const input::Every& every);

/// Runs the check of the loop and reports what it finds at its places.
void checkLoop(const PlacedFacts& placed, input::Diagnostics& diagnostics);

}  // namespace sphinx::build
