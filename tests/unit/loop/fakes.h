// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../memory_archive.h"
#include "loop/plan/plan.h"
#include "loop/run/runner.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace sphinx::loop::fake {

/// One call as a method saw it.
struct Event {
    std::string name;
    double time = 0;
    double dt = 0;
    std::int64_t steps = 0;
    bool operator==(const Event&) const = default;
};
using Journal = std::vector<Event>;

/// A method with one action.
class Acting : public dynamics::Method {
 public:
    explicit Acting(std::function<void(const Clock&)> act) : act_(std::move(act)) {}
    void run(const Clock& clock) { act_(clock); }
    std::size_t workSize() const override { return 1; }

 private:
    std::function<void(const Clock&)> act_;
};

class Recorder : public Acting {
 public:
    Recorder(const std::string& name, Journal& journal)
        : Acting([=, this](const Clock& clock) { record(name, clock); }),
          name_(name),
          journal_(journal) {}
    /// Another action.
    void second(const Clock& clock) { record(name_ + ".second", clock); }
    std::size_t workSize() const override { return 10; }

 private:
    void record(const std::string& name, const Clock& clock) {
        journal_.push_back({name, clock.time, clock.dt, clock.steps});
    }
    std::string name_;
    Journal& journal_;
};

inline void runOf(dynamics::Method& method, const Clock& clock) {
    static_cast<Acting&>(method).run(clock);
}
inline void secondOf(dynamics::Method& method, const Clock& clock) {
    static_cast<Recorder&>(method).second(clock);
}

class Estimate : public dynamics::TimeStepMethod {
 public:
    explicit Estimate(std::function<double()> next) : next_(std::move(next)) {}
    double estimate() override { return next_(); }
    std::size_t workSize() const override { return 10; }

 private:
    std::function<double()> next_;
};

class RecordingOutput : public Output {
 public:
    RecordingOutput(std::string name, Journal& journal)
        : name_(std::move(name)), journal_(journal) {}
    FileWork take(const Clock& clock) override {
        journal_.push_back({name_, clock.time, clock.dt, clock.steps});
        ++frames_;
        if (on_take) on_take();
        return {on_write};
    }
    void transfer(Archive& archive) override { archive.value("frames", frames_); }
    void resume(const Clock& clock) override {
        journal_.push_back({"resume " + name_, clock.time, clock.dt, clock.steps});
    }
    void finish() override { ++finished; }

    std::int64_t frames() const { return frames_; }
    std::function<void()> on_take;
    std::function<void()> on_write;  // by the thread that writes
    int finished = 0;

 private:
    std::string name_;
    Journal& journal_;
    std::int64_t frames_ = 0;
};

using test::MemoryArchive;
using test::Saved;

inline Call acting(std::string label, dynamics::Method& method, std::optional<Trigger> every = {},
                   Window window = {}) {
    return {{std::move(label), 0, {}, {}, std::move(every), window}, &method, runOf};
}

inline Step call(std::string label, dynamics::Method& method, dynamics::ActionCall action = runOf) {
    return {Call{{std::move(label)}, &method, action}};
}

inline Step every(std::string label, dynamics::Method& method, Trigger trigger) {
    return {acting(std::move(label), method, std::move(trigger))};
}

inline Layer fixedLayer(std::string name, double dt, std::vector<Step> steps,
                        Fit fit = Fit::split) {
    return {std::move(name), {}, dt, fit, std::move(steps)};
}

inline Trigger eachTime(double interval) { return {Trigger::Kind::time, interval, ""}; }
inline Trigger eachSteps(int n, std::string layer = "") {
    return {Trigger::Kind::steps, static_cast<double>(n), std::move(layer)};
}

inline Plan planUntil(double end_time, Layer outermost, std::vector<OutputEntry> outputs = {}) {
    Plan plan;
    plan.end_time = end_time;
    plan.outermost = std::move(outermost);
    plan.outputs = std::move(outputs);
    return plan;
}

struct Outcome {
    bool finished = false;  ///< the end time was reached
    std::string reason;     ///< why not
};

/// Called after every step: returns a reason to stop.
using Stop = std::function<std::optional<std::string>(const Clock&)>;

/// A whole run, or a part of it: until `stop` has a reason, or none of it for one before the steps.
template <class AnyRunner>
Outcome runAll(AnyRunner&& runner, const Stop& stop, std::optional<std::string> reason = {}) {
    runner.begin();
    while (!runner.finished() && !reason)
        runner.step([&](const Clock& clock) { reason = stop(clock); });
    runner.end();
    return {runner.finished(), runner.finished() ? "" : *reason};
}

}  // namespace sphinx::loop::fake
