// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fakes.h"
#include "loop/runner.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

TEST_CASE("an output that samples does so after every step, before anything is written") {
    struct Sampling : RecordingOutput {
        using RecordingOutput::RecordingOutput;
        bool samplesEveryStep() const override { return true; }
        void sample(const Clock& clock) override {
            seen->push_back({"sample", clock.time, clock.dt, clock.steps});
        }
        Journal* seen = nullptr;
    };
    Journal journal;
    RecordingOutput frame("frame", journal);
    Sampling mean("row", journal);
    mean.seen = &journal;
    Plan plan;
    plan.end_time = 0.75;
    plan.outermost = fixedLayer("outer", 0.25, {});
    plan.outputs = {{"frames", "vtu", &frame, eachSteps(2), false},
                    {"mean", "observe", &mean, eachSteps(2), false}};
    Runner runner(plan);
    runner.run([](const Clock&) { return std::nullopt; });
    CHECK(journal == Journal{{"frame", 0, 0, 0},
                             {"row", 0, 0, 0},
                             {"sample", 0.25, 0.25, 1},
                             {"sample", 0.5, 0.25, 2},
                             {"frame", 0.5, 0.25, 2},
                             {"row", 0.5, 0.25, 2},
                             {"sample", 0.75, 0.25, 3},
                             {"frame", 0.75, 0.25, 3},
                             {"row", 0.75, 0.25, 3}});
}
