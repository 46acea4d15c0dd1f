// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/plan/plan.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace sphinx::loop {

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

/// A loop before any particle exists: its plan as the case describes it, and what else its check
/// has to know.
struct LoopFacts {
    Plan plan;
    std::vector<BodyFacts> bodies;
    std::vector<ListFacts> lists;
    std::string time_unit;  ///< behind times in messages: " ms"
    std::vector<FieldMaker> makers;
    /// What to do where nothing writes a field that methods add to.
    std::map<std::string, std::string> remedies;
};

}  // namespace sphinx::loop
