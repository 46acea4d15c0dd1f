// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fakes.h"
#include "loop/run/runner.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

struct Sampling : RecordingOutput {
    Sampling(std::string name, Journal& journal, std::string layer)
        : RecordingOutput(std::move(name), journal), seen(journal), of(std::move(layer)) {}
    std::optional<std::string> sampledLayer() const override { return of; }
    void sample(const Clock& clock) override {
        seen.push_back({"sample " + of, clock.time, clock.dt, clock.steps});
        if (on_sample) on_sample();
    }
    Journal& seen;
    std::string of;
    std::function<void()> on_sample;
};

Outcome toTheEnd(Runner& runner) {
    return runAll(runner, [](const Clock&) { return std::nullopt; });
}

/// An output that samples a layer and is the only one of its plan.
struct Mean {
    explicit Mean(const std::string& layer) : row("row", journal, layer) {}
    Plan of(double end_time, Layer outermost, std::optional<Trigger> when = {}) {
        return planUntil(end_time, std::move(outermost),
                         {{"mean", "observe", &row, std::move(when), false}});
    }

    Journal journal;
    Sampling row;
};

}  // namespace

TEST_CASE("an output that samples does so after every step, before anything is written") {
    const std::string layer = GENERATE("", "outer");
    Journal journal;
    RecordingOutput frame("frame", journal);
    Sampling mean("row", journal, layer);
    Plan plan = planUntil(0.75, fixedLayer("outer", 0.25, {}),
                          {{"frames", "vtu", &frame, eachSteps(2), false},
                           {"mean", "observe", &mean, eachSteps(2), false}});
    Runner runner(plan);
    runAll(runner, [&](const Clock& clock) {
        journal.push_back({"looked at", clock.time, clock.dt, clock.steps});
        return std::nullopt;
    });
    const std::string sample = "sample " + layer;
    CHECK(journal == Journal{{"frame", 0, 0, 0},
                             {"row", 0, 0, 0},
                             {"looked at", 0.25, 0.25, 1},
                             {sample, 0.25, 0.25, 1},
                             {"looked at", 0.5, 0.25, 2},
                             {sample, 0.5, 0.25, 2},
                             {"frame", 0.5, 0.25, 2},
                             {"row", 0.5, 0.25, 2},
                             {"looked at", 0.75, 0.25, 3},
                             {sample, 0.75, 0.25, 3},
                             {"frame", 0.75, 0.25, 3},
                             {"row", 0.75, 0.25, 3}});
}

TEST_CASE("an inner layer is sampled at the end of each of its substeps, with its clock") {
    Journal journal;
    Recorder acoustic("acoustic", journal);
    Recorder after("after", journal);
    Sampling mean("row", journal, "inner");
    Plan plan =
        planUntil(1,
                  fixedLayer("outer", 0.5,
                             {{fixedLayer("inner", 0.375, {call("acoustic", acoustic)}, Fit::clip)},
                              call("after", after)}),
                  {{"mean", "observe", &mean, eachSteps(1), false}});
    Runner runner(plan);
    toTheEnd(runner);
    CHECK(journal == Journal{{"row", 0, 0, 0},
                             {"acoustic", 0, 0.375, 0},
                             {"sample inner", 0.375, 0.375, 1},
                             {"acoustic", 0.375, 0.125, 1},
                             {"sample inner", 0.5, 0.125, 2},
                             {"after", 0, 0.5, 0},
                             {"row", 0.5, 0.5, 1},
                             {"acoustic", 0.5, 0.375, 2},
                             {"sample inner", 0.875, 0.375, 3},
                             {"acoustic", 0.875, 0.125, 3},
                             {"sample inner", 1, 0.125, 4},
                             {"after", 0.5, 0.5, 1},
                             {"row", 1, 0.5, 2}});
}

TEST_CASE("a substep that a layer inside it lengthens is sampled with the length it took") {
    Mean mean("middle");
    Plan plan = mean.of(
        1,
        fixedLayer("outer", 1,
                   {{fixedLayer("middle", 0.5, {{fixedLayer("inner", 0.375, {}, Fit::overshoot)}},
                                Fit::overshoot)}}));
    Runner runner(plan);
    toTheEnd(runner);
    CHECK(mean.journal == Journal{{"row", 0, 0, 0},
                                  {"sample middle", 0.75, 0.75, 1},
                                  {"sample middle", 1.5, 0.75, 2},
                                  {"row", 1.5, 1.5, 1}});
}

TEST_CASE("a layer to sample must exist") {
    Mean mean("acustic");
    CHECK_THROWS_WITH(Runner(mean.of(0, fixedLayer("outer", 1, {}))),
                      "loop: output mean: no layer acustic to sample");
}

TEST_CASE("what an output samples inside of the loop is counted as its time alone") {
    Mean mean("inner");
    mean.row.on_sample = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
    // A busy machine may make the loop, which does nothing, wait as long as the samples: the least
    // of some runs counts.
    double loop_seconds = 1, line_seconds = 1, inner_seconds = 1;
    for (int run = 0; run < 5; ++run) {
        Plan plan = mean.of(1, fixedLayer("outer", 1, {{fixedLayer("inner", 0.25, {})}}));
        Runner runner(plan);
        toTheEnd(runner);
        const Profile profile = runner.profile();
        CHECK(profile.output_seconds >= 0.08);
        CHECK(profile.outputs.front().calls == 6);
        loop_seconds = std::min(loop_seconds, profile.loop_seconds);
        line_seconds = std::min(line_seconds, profile.lines.front().seconds);
        inner_seconds = std::min(inner_seconds, profile.lines.front().lines.front().seconds);
    }
    CHECK(loop_seconds < 0.04);
    CHECK(line_seconds < 0.04);
    CHECK(inner_seconds < 0.04);
}
