// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/measure.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace sphinx;

TEST_CASE("the measure of a boolean in space is found from its cells") {
    const auto shell = geometry::makeDifference<3>(
        {geometry::makeBall<3>({0.013, 0, 0}, 1), geometry::makeBall<3>({0.013, 0, 0}, 0.5)});
    REQUIRE(std::isnan(shell->measure()));
    const double exact = 4. / 3 * std::numbers::pi * (1 - 0.125);
    CHECK(fitting::measure<3>(*shell, {0.1, Vec<3>::Zero()}) == Approx(exact).epsilon(2e-3));
    const auto half = geometry::makeIntersection<3>(
        {geometry::makeBall<3>({0, 0, 0}, 1), geometry::makeBox<3>({-2, -2, -2}, {2, 2, 0})});
    CHECK(fitting::measure<3>(*half, {0.1, Vec<3>::Zero()}) ==
          Approx(2. / 3 * std::numbers::pi).epsilon(2e-3));
    const auto disc = geometry::makeBall<2>({0, 0}, 1);
    CHECK(fitting::measure<2>(*disc, {0.1, Vec<2>::Zero()}) == disc->measure());
}

TEST_CASE("layers at surfaces are measured by cells") {
    const auto box = geometry::makeBox<3>({0, 0, 0}, {1, 1, 1});
    CHECK(fitting::measureLayer<3>(*box, {0.1, Vec<3>::Zero()}, 0.1) ==
          Approx(1 - std::pow(0.8, 3)).epsilon(1e-6));
    const auto disc = geometry::makeBall<2>({0.02, 0.01}, 1);
    CHECK(fitting::measureLayer<2>(*disc, {0.1, Vec<2>::Zero()}, 0.1) ==
          Approx(std::numbers::pi * (1 - 0.81)).epsilon(5e-3));
}
