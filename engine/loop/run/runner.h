// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/progress.h"
#include "core/timer.h"
#include "loop/run/output_schedule.h"
#include "loop/run/profile.h"

#include <functional>
#include <optional>
#include <string>

namespace sphinx::loop {

/// Called after every outermost step, before outputs write: the place to check the state (throw
/// PhysicsError) and to look at signals and limits (return a reason to stop). The clock stands at
/// the end of the step.
using AfterStep = std::function<std::optional<std::string>(const Clock& clock)>;

/// Called before the first step: returns a reason not to make it, such as a signal.
using BeforeSteps = std::function<std::optional<std::string>()>;

struct Outcome {
    bool finished = false;  ///< the end time was reached
    std::string reason;     ///< why not
};

/// A run from its start, or from a restart, to its end. Use: construct; transfer() from a loading
/// archive to resume; run() once.
class Runner {
 public:
    /// Throws std::invalid_argument, see validate().
    explicit Runner(Plan plan);

    /// Start calls (not after a restart) and first outputs, then outermost steps until the end time
    /// is reached or `before_steps` or `after_step` asks to stop; restarts are written in each
    /// case. Errors of methods and outputs pass through; files then stay as the last write left
    /// them.
    Outcome run(const AfterStep& after_step, const BeforeSteps& before_steps = {});

    /// Clocks, triggers and outputs' own states. The state of methods and the particle fields are
    /// the caller's.
    void transfer(Archive& archive);
    /// After transfer(), for a run that goes on in another folder: the state is to be kept there as
    /// well, also when no step is made.
    void leaveRestarts() { outputs_.leaveRestarts(); }
    bool resumed() const { return resumed_; }

    /// Of the outermost layer.
    const Clock& clock() const { return outermost_.clock(); }
    Progress progress() const;
    Profile profile() const;

 private:
    void start();
    bool finished() const;

    const Plan plan_;
    LayerRun outermost_;
    OutputSchedule outputs_;
    bool resumed_ = false;
    std::vector<Tally> start_tallies_;
    Tally after_step_;
    Timer wall_;             // since run()
    double first_time_ = 0;  // case time and steps at the beginning of run()
    std::int64_t first_step_ = 0;
};

}  // namespace sphinx::loop
