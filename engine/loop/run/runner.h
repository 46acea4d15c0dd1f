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
#include <utility>

namespace sphinx::loop {

/// Called after an outermost step, before outputs write: the place to check the state (throw
/// PhysicsError). The clock stands at the end of the step.
using AfterStep = std::function<void(const Clock& clock)>;

/// A run from its start, or from a restart, to its end. Use: construct; transfer() from a loading
/// archive to resume; begin(); step() as long as it is not finished(), or less often; end().
/// Errors of methods and outputs pass through; files then stay as the last write left them.
class Runner {
 public:
    /// Throws std::invalid_argument, see validate().
    explicit Runner(Plan plan);

    /// Start calls and first outputs; after a restart outputs go on instead.
    void begin();
    /// One outermost step, the check, then the outputs that are due.
    void step(const AfterStep& check);
    /// The end time is reached.
    bool finished() const;
    /// Last outputs; of a run that is not finished its restarts only.
    void end();
    /// OutputSchedule::sync
    void syncOutputs() { outputs_.sync(); }
    /// OutputSchedule::watchWrites
    void watchWrites(std::function<void()> watch) { outputs_.watchWrites(std::move(watch)); }

    /// Clocks, triggers and outputs' own states. The state of methods and the particle fields are
    /// the caller's.
    void transfer(Archive& archive);
    /// After transfer(), for a run that goes on in another folder: the state is to be kept there as
    /// well, also when no step is made.
    void leaveFolder() { outputs_.leaveFolder(); }
    bool resumed() const { return resumed_; }
    /// LayerRun::watchSubsteps of the outermost layer.
    void watchSubsteps(const std::function<void()>& watch) { outermost_.watchSubsteps(watch); }

    /// Of the outermost layer.
    const Clock& clock() const { return outermost_.clock(); }
    Progress progress() const;
    Profile profile() const;

 private:
    void start();

    const Plan plan_;
    LayerRun outermost_;
    OutputSchedule outputs_;
    bool resumed_ = false;
    std::vector<Tally> start_tallies_;
    Tally after_step_;
    Timer wall_;             // since begin()
    double first_time_ = 0;  // case time and steps at begin()
    std::int64_t first_step_ = 0;
};

}  // namespace sphinx::loop
