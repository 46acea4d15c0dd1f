// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/fit.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace sphinx::loop;

namespace {

/// All substeps over an interval.
std::vector<Substep> cover(Fit fit, double from, double until, double estimate) {
    std::vector<Substep> steps;
    double time = from;
    while (time < until) {
        steps.push_back(fitSubstep(fit, time, until, estimate));
        REQUIRE(steps.back().end > time);
        time = steps.back().end;
    }
    return steps;
}

}  // namespace

TEST_CASE("split fills the interval with equal parts below the estimate") {
    const auto steps = cover(Fit::split, 1.0, 2.0, 0.3);
    REQUIRE(steps.size() == 4);
    CHECK(steps[0].dt == 0.25);
    CHECK(steps[0].end == 1.25);
    CHECK(steps.back().end == 2.0);
}

TEST_CASE("split ends at the parent's time by assignment") {
    // Neither the parts nor the interval are representable.
    const double from = 0.1, until = 0.1 + 0.7;
    for (const double estimate : {0.09, 0.013, 0.1, 0.7, 5.0}) {
        const auto steps = cover(Fit::split, from, until, estimate);
        CHECK(steps.back().end == until);
        for (const Substep& s : steps) CHECK(s.dt <= estimate * (1 + 2 * rounding_part));
    }
}

TEST_CASE("split makes no extra substep of a rounding error") {
    // 0.1 + 0.2 - 0.1 is above 0.2.
    CHECK(cover(Fit::split, 0.1, 0.1 + 0.2, 0.1).size() == 2);
    CHECK(cover(Fit::split, 1234.5, 1234.5 + 0.1, 0.01).size() == 10);
}

TEST_CASE("clip takes the estimate and cuts the last substep") {
    const auto steps = cover(Fit::clip, 0.0, 1.0, 0.375);
    REQUIRE(steps.size() == 3);
    CHECK(steps[0].dt == 0.375);
    CHECK(steps[1].end == 0.75);
    CHECK(steps[2].dt == 0.25);
    CHECK(steps[2].end == 1.0);
}

TEST_CASE("clip leaves no sliver") {
    // Ten times 0.1 fall short of 1 by one bit; the tenth substep ends at 1 instead.
    const auto steps = cover(Fit::clip, 0.0, 1.0, 0.1);
    REQUIRE(steps.size() == 10);
    CHECK(steps.back().end == 1.0);
}

TEST_CASE("overshoot takes the estimate to the end") {
    const auto steps = cover(Fit::overshoot, 0.0, 1.0, 0.375);
    REQUIRE(steps.size() == 3);
    CHECK(steps.back().dt == 0.375);
    CHECK(steps.back().end == 1.125);
}
