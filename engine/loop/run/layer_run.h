// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "loop/plan/plan.h"
#include "loop/run/tally.h"

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace sphinx::loop {

/// A layer at work: its clock, its lines, what they cost. Refers to the plan's Layer, which must
/// outlive it and stay in place.
class LayerRun {
 public:
    struct CallRun {
        const Call* call = nullptr;
        std::optional<Multiples> every;
        const LayerRun* counting = nullptr;  ///< whose steps `every` counts
        bool under_way = false;  ///< the counting layer is in a substep when the call's turn comes
        bool to_rest = false;    ///< it has acted in its window, whose end is to come
        Tally tally;
    };
    using Line = std::variant<CallRun, std::unique_ptr<LayerRun>>;

    /// Of an outermost layer, with everything inside it.
    LayerRun(const Layer& layer, double start_time);
    LayerRun(const LayerRun&) = delete;
    LayerRun& operator=(const LayerRun&) = delete;

    /// One step of the outermost layer: the estimate unchanged. Throws PhysicsError for a step
    /// that is not a positive number or too small to advance the time.
    void stepFreely();

    const Layer& layer() const { return layer_; }
    const Clock& clock() const { return clock_; }
    const std::vector<Line>& lines() const { return lines_; }
    const std::vector<Tally>& estimateTallies() const { return estimate_tallies_; }
    const Tally& tally() const { return tally_; }

    /// This layer or one inside it; empty means this one; nullptr when there is none.
    LayerRun* find(std::string_view name);

    /// Has the sampler called at the end of each substep, with this layer's clock. What it takes is
    /// not counted as time of the loop.
    void sampleSubsteps(std::function<void(const Clock&)> sampler);

    /// Has it called before each substep of the layers inside this one. What it throws ends the
    /// step in its midst: nothing can go on from there.
    void watchSubsteps(const std::function<void()>& watch);

    /// Clocks, triggers and windows under way of this layer and of all inside it, a section for
    /// each layer.
    void transfer(Archive& archive);

 private:
    LayerRun(const Layer& layer, double start_time, LayerRun* parent);
    void connectTriggers(LayerRun& outermost);
    bool isInside(const LayerRun* other) const;
    double estimate();
    /// Counts a substep that began at that lap.
    void count(std::int64_t began);
    /// Substeps from `from` up to `until`; returns the time that was covered.
    double cover(double from, double until);
    void substep(double dt, double end);
    /// Lets the methods of windows that are over rest.
    void endWindows();
    void run(CallRun& line);
    void sample();
    bool due(CallRun& line) const;
    [[noreturn]] void fail(const std::string& message) const;

    const Layer& layer_;
    LayerRun* parent_;
    Clock clock_;
    double begin_ = 0;  // of the substep under way, as windows compare it
    std::vector<Line> lines_;
    std::vector<Tally> estimate_tallies_;
    std::vector<std::function<void(const Clock&)>> samplers_;
    std::function<void()> watch_;
    Tally tally_;  // calls are substeps
    Laps own_laps_;
    Laps& laps_;  // those of the outermost layer: one line at a time acts
};

/// Time of a layer at the begin or end of the substep under way or just done, with the allowance
/// for rounding: the value that windows (begin) and time triggers (end) compare.
double triggerTime(double time, double dt);

}  // namespace sphinx::loop
