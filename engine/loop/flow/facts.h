// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/dynamics.h"
#include "loop/plan/fit.h"
#include "loop/plan/window.h"

#include <set>
#include <string>
#include <variant>
#include <vector>

namespace sphinx::loop {

/// What is known of a loop before any particle exists: the shape of it and what its lines declare.
/// Ids are the caller's (they stand for places in the case file) and come back in messages.

/// A call, an estimate of a time step, or an output.
struct LineFacts {
    int id = 0;
    std::string label;
    /// An action that writes only some particles of a body declares the field as read, too.
    std::vector<FieldAccess> accesses;
    std::vector<std::string> permutes;  ///< bodies whose particles it may reorder or remove
    bool sometimes = false;             ///< under `every:`
    Window window = {};                 ///< of a line of the loop

    bool inEverySubstep() const { return !sometimes && !window.limited(); }
};

struct StepFacts;

struct LayerFacts {
    int id = 0;
    std::string name;
    Fit fit = Fit::split;
    std::vector<LineFacts> dt;
    bool fixed_dt = false;
    std::vector<StepFacts> steps;
};

struct StepFacts {
    std::variant<LineFacts, LayerFacts> value;
};

struct BodyFacts {
    std::string name;
    bool moves = false;  ///< by its kind: fluids and elastic solids
    /// Fields with an initial value besides id and position. A field that methods accumulate or
    /// that has a meaningful zero belongs here.
    std::vector<std::string> initial;
};

/// The particles of `other` that those of `owner` see.
struct ListFacts {
    std::string owner;
    std::string other;
    bool reference_configuration = false;  ///< built once: motion does not make it stale
};

/// A type of method that could be added to a case, and the fields of its body that it computes from
/// scratch: advice where one of them is missing.
struct FieldMaker {
    std::string method;
    std::set<std::string> fields;
};

struct LoopFacts {
    std::vector<BodyFacts> bodies;
    std::vector<ListFacts> lists;
    double start_time = 0;
    std::string time_unit;  ///< behind times in messages: " ms"
    std::vector<LineFacts> start;
    LayerFacts outermost;
    std::vector<LineFacts> outputs;  ///< read after outermost steps, not in all of them
    std::vector<FieldMaker> makers;
};

}  // namespace sphinx::loop
