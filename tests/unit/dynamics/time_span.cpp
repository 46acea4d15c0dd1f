// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/time_span.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx::dynamics::multibody;

TEST_CASE("derivatives of a motion over a step") {
    const TimeSpan span{2, 0.5};
    const auto quartic = [](double t) { return 1 + t * (2 + t * (3 + t * (4 + t * 5))); };
    for (const double t : {2.0, 2.25, 2.5}) {
        const auto d = span.derivatives(quartic, t);
        CHECK(d.first == Approx(2 + t * (6 + t * (12 + t * 20))).epsilon(1e-11));
        CHECK(d.second == Approx(6 + t * (24 + t * 60)).epsilon(1e-10));
    }
    // Halving the step divides the errors by 16 and by 8.
    const auto errors = [](double h) {
        const auto d = TimeSpan{1, h}.derivatives([](double t) { return std::sin(t); }, 1);
        return std::pair(std::abs(d.first - std::cos(1)), std::abs(d.second + std::sin(1)));
    };
    CHECK(errors(0.1).first / errors(0.05).first == Approx(16).epsilon(0.05));
    CHECK(errors(0.1).second / errors(0.05).second == Approx(8).epsilon(0.05));
}

TEST_CASE("nothing is asked of a motion beyond its step") {
    const TimeSpan span{0, 0.1};
    span.derivatives(
        [](double t) {
            CHECK(t >= 0);
            CHECK(t <= 0.1);
            return t;
        },
        0.1);
}

TEST_CASE("a step resolves a motion or not") {
    for (const double rate : {1e-3, 1.0, 1e6}) {
        const FunctionOfTime wave = [rate](double t) { return 3 + std::sin(rate * t); };
        CHECK(!TimeSpan{0, 2 / rate}.resolves(wave));
        CHECK(TimeSpan{0, 1e-3 / rate}.resolves(wave));
    }
    CHECK(TimeSpan{0, 1}.resolves([](double) { return 7.0; }));
}
