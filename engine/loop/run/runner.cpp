// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/run/runner.h"

#include "core/types.h"

#include <algorithm>
#include <utility>

namespace sphinx::loop {
namespace {

Plan validated(Plan plan) {
    validate(plan);
    return plan;
}

}  // namespace

Runner::Runner(Plan plan)
    : plan_(validated(std::move(plan))),
      outermost_(plan_.outermost, plan_.start_time),
      outputs_(plan_.outputs, outermost_),
      start_tallies_(plan_.start.size()) {}

bool Runner::finished() const { return reached(clock().time, clock().dt, plan_.end_time); }

void Runner::start() {
    Clock at_start = clock();
    at_start.is_start = true;
    for (std::size_t k = 0; k < plan_.start.size(); ++k) {
        const Call& call = plan_.start[k];
        {
            const TimedCall timed(start_tallies_[k]);
            call.act(at_start);
        }
        start_tallies_[k].particles += static_cast<double>(call.method->workSize());
    }
}

void Runner::begin() {
    if (resumed_)
        outputs_.resume();
    else
        start();
    wall_.restart();
    first_time_ = clock().time;
    first_step_ = clock().steps;
    if (!resumed_) outputs_.writeFirst();
}

void Runner::step(const AfterStep& check) {
    outermost_.stepFreely();
    {
        const TimedCall timed(after_step_);
        check(clock());
    }
    outputs_.writeDue(wall_.seconds(), finished());
}

void Runner::end() {
    if (finished())
        outputs_.writeLast();
    else
        outputs_.writeRestarts();
    outputs_.finish();
}

void Runner::transfer(Archive& archive) {
    {
        const Section section(archive, "layers");
        outermost_.transfer(archive);
    }
    outputs_.transfer(archive);
    if (archive.loading()) resumed_ = true;
}

Profile Runner::profile() const {
    Profile profile;
    profile.time = clock().time;
    profile.finished = finished();
    profile.lines.push_back(profileLayer(outermost_, profile.steps));
    profile.lines.push_back(profileLine("checks after each step", "checks", after_step_));
    for (const auto& line : profile.lines) profile.loop_seconds += line.seconds;
    for (std::size_t k = 0; k < plan_.start.size(); ++k) {
        profile.start.push_back(profileLine(plan_.start[k].label, "start", start_tallies_[k]));
        profile.start_seconds += profile.start.back().seconds;
    }
    for (const OutputSchedule::EntryRun& run : outputs_.entries()) {
        profile.outputs.push_back(profileLine(run.entry.name, "output", run.tally));
        profile.output_seconds += profile.outputs.back().seconds;
        if (run.writing.calls == 0) continue;
        profile.writing.push_back(profileLine(run.entry.name, "writing", run.writing));
        profile.writing_seconds += profile.writing.back().seconds;
    }
    setShares(profile);
    return profile;
}

Progress Runner::progress() const {
    Progress progress;
    progress.time = clock().time;
    progress.end_time = plan_.end_time;
    const double whole = plan_.end_time - plan_.start_time;
    const double done = clock().time - plan_.start_time;
    progress.fraction = whole > 0 ? std::clamp(done / whole, 0.0, 1.0) : 1.0;
    progress.steps = clock().steps;
    progress.dt = clock().dt;
    progress.seconds = wall_.seconds();
    progress.seconds_left = nan_value;
    const auto steps = static_cast<double>(clock().steps - first_step_);
    if (steps > 0 && progress.seconds > 0) {
        progress.steps_per_second = steps / progress.seconds;
        const double left = std::max(0.0, plan_.end_time - clock().time);
        progress.seconds_left = progress.seconds * left / (clock().time - first_time_);
    }
    return progress;
}

}  // namespace sphinx::loop
