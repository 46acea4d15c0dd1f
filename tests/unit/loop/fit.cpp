// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/fit.h"

#include <catch2/catch.hpp>

#include <algorithm>
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

namespace {

/// Work per time of an outermost step that costs two substeps besides those that cover it.
double workPerTime(double step, double estimate) {
    return (2 + static_cast<double>(cover(Fit::split, 0, step, estimate).size())) / step;
}

}  // namespace

TEST_CASE("an economic step is no longer than its limit, and shorter where that saves work") {
    const double estimate = 0.1;
    int shortened = 0;
    for (double limit = 0.03; limit < 3; limit *= 1.017) {
        const double step = economicStep(limit, estimate);
        REQUIRE(step <= limit);
        REQUIRE(step > 0.75 * limit);
        const double work = workPerTime(limit, estimate);
        const bool shorter = step < 0.997 * limit;  // not only by the reserve
        if (shorter) REQUIRE(workPerTime(step, estimate) < 0.97 * work);
        for (int n = 1; n * estimate <= limit; ++n)
            REQUIRE(0.966 * std::min(work, workPerTime(step, estimate)) <
                    workPerTime(n * estimate, estimate));
        shortened += shorter;
    }
    CHECK(shortened > 50);
}

TEST_CASE("an economic step by numbers") {
    CHECK(economicStep(0.05, 0.1) == 0.05);
    CHECK(economicStep(0.42, 0.1) == Approx(0.4).epsilon(0.003));
    CHECK(economicStep(0.458, 0.1) == 0.458);  // 7 / 4.58, hardly more than 6 / 4
    CHECK(economicStep(0.475, 0.1) == 0.475);  // 7 / 4.75 < 6 / 4
    CHECK(economicStep(0.12, 0.1) == Approx(0.1).epsilon(0.003));
    CHECK(economicStep(0.14, 0.1) == 0.14);  // 4 / 1.4 < 3 / 1
}

TEST_CASE("an estimate that sinks a little asks for no substep more") {
    const double step = economicStep(0.44, 0.1);
    double time = 0;
    int steps = 0;
    for (double estimate = 0.1; time < step; estimate *= 0.9995, ++steps)
        time = fitSubstep(Fit::split, time, step, estimate).end;
    CHECK(steps == 4);
}
