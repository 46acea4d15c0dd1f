// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "fakes.h"
#include "loop/run/layer_run.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <utility>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

/// So many steps of a layer that has no parent.
void stepFreely(const Layer& outer, int steps) {
    LayerRun run(outer, 0);
    for (int k = 0; k < steps; ++k) run.stepFreely();
}

}  // namespace

TEST_CASE("lines run in order, each with the clock of its own layer") {
    Journal journal;
    Recorder a("a", journal), b("b", journal), c("c", journal);
    const Layer inner = fixedLayer("inner", 0.5, {call("b", b, secondOf)});
    const Layer outer = fixedLayer("outer", 1.0, {call("a", a), {inner}, call("c", c)});
    LayerRun run(outer, 3.0);
    run.stepFreely();
    CHECK(journal ==
          Journal{
              {"a", 3, 1, 0}, {"b.second", 3, 0.5, 0}, {"b.second", 3.5, 0.5, 1}, {"c", 3, 1, 0}});
    journal.clear();
    run.stepFreely();
    CHECK(journal ==
          Journal{
              {"a", 4, 1, 1}, {"b.second", 4, 0.5, 2}, {"b.second", 4.5, 0.5, 3}, {"c", 4, 1, 1}});
    CHECK(run.clock().time == 5);
    CHECK(run.clock().steps == 2);
    CHECK(run.find("inner")->clock().time == 5);
    CHECK(run.find("inner")->clock().steps == 4);
    CHECK(run.find("none") == nullptr);
}

TEST_CASE("a method sees where the interval of its layer starts") {
    std::vector<double> inside, outside;
    Acting inner_line([&](const Clock& clock) { inside.push_back(clock.interval_start); });
    Acting outer_line([&](const Clock& clock) { outside.push_back(clock.interval_start); });
    const Layer inner = fixedLayer("inner", 0.5, {call("inner_line", inner_line)});
    const Layer outer = fixedLayer("outer", 1.0, {{inner}, call("outer_line", outer_line)});
    LayerRun run(outer, 3.0);
    run.stepFreely();
    run.stepFreely();
    CHECK(inside == std::vector<double>{3, 3, 4, 4});
    CHECK(outside == std::vector<double>{3, 4});
}

TEST_CASE("dt is evaluated once at the start of each substep") {
    Journal journal;
    Recorder act("act", journal);
    double next = 0.25;
    Estimate shrinking([&] {
        journal.push_back({"dt", 0, next, 0});
        return std::exchange(next, next / 2);
    });
    Layer inner{"inner", {{{"shrinking"}, &shrinking}}, {}, Fit::clip, {call("act", act)}};
    const Layer outer = fixedLayer("outer", 0.4375, {{inner}});
    LayerRun run(outer, 0);
    run.stepFreely();
    CHECK(journal == Journal{{"dt", 0, 0.25, 0},
                             {"act", 0, 0.25, 0},
                             {"dt", 0, 0.125, 0},
                             {"act", 0.25, 0.125, 1},
                             {"dt", 0, 0.0625, 0},
                             {"act", 0.375, 0.0625, 2}});
    CHECK(run.clock().time == 0.4375);
}

TEST_CASE("split evaluates its parts anew from what remains") {
    Journal journal;
    Recorder act("act", journal);
    double next = 0.5;
    Estimate estimate([&] { return std::exchange(next, 0.2); });
    Layer inner{"inner", {{{"estimate"}, &estimate}}, {}, Fit::split, {call("act", act)}};
    const Layer outer = fixedLayer("outer", 1.0, {{inner}});
    LayerRun run(outer, 0);
    run.stepFreely();
    REQUIRE(journal.size() == 4);
    CHECK(journal[0].dt == 0.5);
    CHECK(journal[1].dt == 0.5 / 3);
    CHECK(run.find("inner")->clock().time == 1.0);
}

TEST_CASE("nested layers end at their parent's time, bitwise") {
    Journal journal;
    Recorder act("act", journal);
    double wobble = 0;
    Estimate irregular([&] { return 0.0137 * (1.1 + std::sin(wobble += 0.7)); });
    for (const Fit fit : {Fit::split, Fit::clip}) {
        Layer innermost{"innermost", {{{"dt"}, &irregular}}, 0.003, fit, {call("act", act)}};
        Layer middle{"middle", {{{"dt"}, &irregular}}, {}, fit, {{innermost}}};
        const Layer outer{"outer", {{{"dt"}, &irregular}}, {}, Fit::split, {{middle}}};
        LayerRun run(outer, 0.1);
        for (int k = 0; k < 200; ++k) {
            run.stepFreely();
            REQUIRE(run.find("middle")->clock().time == run.clock().time);
            REQUIRE(run.find("innermost")->clock().time == run.clock().time);
        }
        CHECK(run.find("innermost")->clock().steps > run.find("middle")->clock().steps);
        CHECK(run.find("middle")->clock().steps >= run.clock().steps);
    }
}

TEST_CASE("overshoot: the parent's interval becomes what was covered") {
    Journal journal;
    Recorder act("act", journal), after("after", journal);
    const Layer second = fixedLayer("second", 1.0, {call("act", act)});
    const Layer first = fixedLayer("first", 0.375, {}, Fit::overshoot);
    const Layer outer = fixedLayer("outer", 1.0, {{first}, {second}, call("after", after)});
    LayerRun run(outer, 0);
    run.stepFreely();
    // 3 x 0.375; the second layer covers the longer interval.
    CHECK(journal ==
          Journal{{"act", 0, 0.5625, 0}, {"act", 0.5625, 0.5625, 1}, {"after", 0, 1.125, 0}});
    CHECK(run.clock().time == 1.125);
    CHECK(run.clock().dt == 1.125);
    CHECK(run.find("first")->clock().time == 1.125);
    CHECK(run.find("second")->clock().time == 1.125);
}

TEST_CASE("overshoot passes through two layers") {
    const Layer innermost = fixedLayer("innermost", 0.375, {}, Fit::overshoot);
    const Layer middle = fixedLayer("middle", 0.5, {{innermost}}, Fit::overshoot);
    const Layer outer = fixedLayer("outer", 1.0, {{middle}});
    LayerRun run(outer, 0);
    run.stepFreely();
    // The middle layer covers 0.75 twice.
    CHECK(run.clock().time == 1.5);
    CHECK(run.find("middle")->clock().steps == 2);
    CHECK(run.find("innermost")->clock().steps == 4);
}

TEST_CASE("the smallest estimate of a list counts, with the fixed one") {
    Estimate large([] { return 0.5; }), small([] { return 0.25; });
    Layer layer{"only", {{{"large"}, &large}, {{"small"}, &small}}, {}, Fit::split, {}};
    LayerRun run(layer, 0);
    run.stepFreely();
    CHECK(run.clock().dt == 0.25);
    layer.fixed_dt = 0.125;
    LayerRun limited(layer, 0);
    limited.stepFreely();
    CHECK(limited.clock().dt == 0.125);
}

TEST_CASE("a time step that is no positive number names method, layer and time") {
    const double bad = GENERATE(0.0, -1.0, std::numeric_limits<double>::infinity());
    double next = 0.5;
    Estimate estimate([&] { return std::exchange(next, bad); });
    const Layer layer{"acoustic", {{{"acoustic_dt"}, &estimate}}, {}, Fit::split, {}};
    LayerRun run(layer, 2);
    run.stepFreely();
    const std::string number = bad == 0 ? "0" : bad < 0 ? "-1" : "inf";
    CHECK_THROWS_WITH(run.stepFreely(), "acoustic_dt gives a time step of " + number +
                                            " at time 2.5 (layer acoustic, after 1 substeps)");
}

TEST_CASE("a NaN time step is a failure of the physics, in inner layers too") {
    Estimate estimate([] { return std::numeric_limits<double>::quiet_NaN(); });
    const Layer inner{"inner", {{{"acoustic_dt"}, &estimate}}, {}, Fit::split, {}};
    const Layer outer = fixedLayer("outer", 1, {{inner}});
    LayerRun run(outer, 0);
    CHECK_THROWS_AS(run.stepFreely(), PhysicsError);
}

TEST_CASE("a time step below the resolution of the time is a failure") {
    Estimate estimate([] { return 1e-18; });
    const Layer inner{"inner", {{{"dt"}, &estimate}}, {}, Fit::split, {}};
    const Layer outer = fixedLayer("outer", 1, {{inner}});
    LayerRun run(outer, 100);
    CHECK_THROWS_WITH(run.stepFreely(), Catch::Contains("too small to advance the time"));
    LayerRun alone(inner, 100);
    CHECK_THROWS_AS(alone.stepFreely(), PhysicsError);
}

TEST_CASE("every: steps of the outermost layer, counted with the one under way") {
    Journal journal;
    Recorder sort("sort", journal);
    const Layer outer = fixedLayer("outer", 1, {every("sort", sort, eachSteps(3))});
    stepFreely(outer, 7);
    CHECK(journal == Journal{{"sort", 2, 1, 2}, {"sort", 5, 1, 5}});
}

TEST_CASE("every: in an inner layer, by outermost steps, own steps, and time") {
    Journal journal;
    Recorder a("outer steps", journal), b("own steps", journal), c("time", journal);
    const Layer inner =
        fixedLayer("inner", 0.25,
                   {every("a", a, eachSteps(2)), every("b", b, eachSteps(6, "inner")),
                    every("c", c, eachTime(1.5))});
    const Layer outer = fixedLayer("outer", 1, {{inner}});
    stepFreely(outer, 2);
    CHECK(journal == Journal{{"outer steps", 1, 0.25, 4},  // first substep of the second step
                             {"own steps", 1.25, 0.25, 5},
                             {"time", 1.25, 0.25, 5}});
}

TEST_CASE("every: a call counts the steps that a layer beside it has completed") {
    Journal journal;
    Recorder before("before", journal), after("after", journal);
    const Layer inner = fixedLayer("inner", 0.25, {});
    const Layer outer = fixedLayer("outer", 1,
                                   {every("before", before, eachSteps(4, "inner")),
                                    {inner},
                                    every("after", after, eachSteps(4, "inner"))});
    LayerRun run(outer, 0);
    run.stepFreely();
    CHECK(journal == Journal{{"after", 0, 1, 0}});
    run.stepFreely();
    CHECK(journal.size() == 3);
    CHECK(journal[1] == Event{"before", 1, 1, 1});
}

TEST_CASE("ten steps of 0.1 reach a time trigger of 1") {
    Journal journal;
    Recorder act("act", journal);
    const Layer outer = fixedLayer("outer", 0.1, {every("act", act, eachTime(1.0))});
    LayerRun run(outer, 0);
    for (int k = 0; k < 10; ++k) run.stepFreely();
    CHECK(run.clock().time < 1.0);  // the sum of ten roundings
    CHECK(journal.size() == 1);
}
