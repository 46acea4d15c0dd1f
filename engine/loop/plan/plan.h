// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "dynamics/dynamics.h"
#include "loop/plan/fit.h"
#include "loop/plan/trigger.h"
#include "loop/plan/window.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sphinx::loop {

/// A line of the loop as the case and the declaration of its method describe it, before any
/// particle exists: all that the check of the loop (loop/flow) reads.
struct Line {
    std::string label;  ///< as in the case file: "pressure_relaxation.first_half"
    int id = 0;  ///< the caller's (it stands for a place in the case file); messages come with it
    /// An action that writes only some particles of a body declares the field as read, too.
    std::vector<dynamics::FieldAccess> accesses = {};
    std::vector<std::string> permutes = {};  ///< bodies whose particles it may reorder or remove
    /// Without: in every substep. Steps count the one under way, time is the end of the substep;
    /// a wall time is refused, because results would depend on the speed of the machine.
    std::optional<Trigger> every = {};
    Window window = {};  ///< moments of `every` outside of it pass

    bool inEverySubstep() const { return !every && !window.limited(); }
};

/// A line of `start` or `steps`, and what it calls: null until the plan is bound to its methods.
struct Call : Line {
    dynamics::Method* method = nullptr;
    dynamics::ActionCall action = nullptr;  ///< of that method

    void act(const Clock& clock) const { action(*method, clock); }
};

/// An estimate of the time step of a layer.
struct TimeStep : Line {
    dynamics::TimeStepMethod* method = nullptr;  ///< null until the plan is bound
};

struct Step;

/// Covers its parent's interval with substeps; the outermost one runs until the end time.
struct Layer {
    std::string name;                ///< unique in the loop
    std::vector<TimeStep> dt;        ///< the smallest estimate counts
    std::optional<double> fixed_dt;  ///< a limit like the estimates; time, above 0
    Fit fit = Fit::split;            ///< of inner layers
    std::vector<Step> steps;
    int id = 0;  ///< as that of a line
};

struct Step {
    std::variant<Call, Layer> value;
};

/// One entry of `outputs`.
struct OutputEntry {
    std::string name;  ///< unique
    std::string type;  ///< registry name; a saved state is only given back to the same type
    Output* output = nullptr;
    std::optional<Trigger> every;  ///< without: only at the start and at the end
    /// Restarts are written after all other outputs of the same step, at the start only if they say
    /// so, and also when the run is stopped early.
    bool restart = false;
    bool restart_at_start = false;
};

/// A whole run: described first, so that its data flow can be checked; then bound to methods and
/// outputs, which stay the caller's and outlive the runner.
struct Plan {
    double start_time = 0;  ///< case units
    double end_time = 0;    ///< case units; the run ends after the first outermost step reaching it
    std::vector<Call> start;  ///< once, before the first step; `every` does not apply
    Layer outermost;
    std::vector<OutputEntry> outputs;
};

/// Throws std::invalid_argument for a bound plan that cannot run: the data-flow check (check.h) and
/// the reader of the case have refused such a case before, with its place.
void validate(const Plan& plan);

}  // namespace sphinx::loop
