// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/catenary.h"
#include "dynamics/multibody/mechanism.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx::dynamics::multibody;

namespace {
constexpr double stiff = 1e16;
}

TEST_CASE("a line that does not stretch hangs as the catenary") {
    // y = a cosh(s/a) between two places of it.
    const double a = 7, left = GENERATE(-12.0, -3.0, 0.0, 2.0), right = 15;
    const double length = a * (std::sinh(right / a) - std::sinh(left / a));
    const double up = a * (std::cosh(right / a) - std::cosh(left / a));
    const double w = 30;
    const CatenaryShape s = hang({length, stiff, w, false}, right - left, up);
    CHECK(s.across == Approx(w * a).epsilon(1e-8));
    CHECK(s.upper == Approx(w * a * std::sinh(right / a)).epsilon(1e-8));
    CHECK(s.lower == Approx(w * a * std::sinh(left / a)).epsilon(1e-8).margin(1e-6));
    CHECK(s.resting == 0);
}

TEST_CASE("part of a line lies on the ground") {
    // From where it leaves the ground, y = a (cosh(s/a) - 1).
    const double a = GENERATE(0.1, 7.0, 300.0), w = 30, rest = 40, reach = 25;
    const double hanging = a * std::sinh(reach / a), up = a * (std::cosh(reach / a) - 1);
    if (!(up < 1e6)) return;  // the first hangs nearly straight down: see below
    const CatenaryShape s = hang({rest + hanging, stiff, w, true}, rest + reach, up);
    CHECK(s.across == Approx(w * a).epsilon(1e-7));
    CHECK(s.upper == Approx(w * hanging).epsilon(1e-8));
    CHECK(s.lower == 0);
    CHECK(s.resting == Approx(rest).epsilon(1e-7));
}

TEST_CASE("a line longer than it needs to be lies loose on the ground") {
    const CatenaryShape s = hang({100, stiff, 30, true}, 20, 50);
    CHECK(s.across == 0);
    CHECK(s.upper == Approx(30 * 50));
    CHECK(s.resting == Approx(50));
    CHECK(hang({100, stiff, 30, true}, 20, 0).energy == 0);
}

TEST_CASE("a light line is a spring") {
    const double EA = 1e5, L = 10;
    for (const bool ground : {false, true}) {
        const CatenaryShape s = hang({L, EA, 1e-6, ground}, 9, 12);
        const double tension = EA * (15 / L - 1);
        CHECK(s.across == Approx(tension * 9 / 15).epsilon(1e-6));
        CHECK(s.upper == Approx(tension * 12 / 15).epsilon(1e-6));
        CHECK(s.energy == Approx(0.5 * EA / L * 25).epsilon(1e-6));
    }
}

TEST_CASE("both ends in one vertical line") {
    const double w = 30, L = 100;
    CatenaryShape s = hang({L, stiff, w, false}, 0, 20);
    CHECK(s.across == 0);
    CHECK(s.upper == Approx(w * 60).epsilon(1e-6));
    CHECK(s.lower == Approx(-w * 40).epsilon(1e-6));
    // Taut: its own weight stretches it by w L^2/(2 EA).
    const double EA = 1e6;
    s = hang({L, EA, w, false}, 0, 101);
    CHECK(s.upper == Approx(EA * 0.01 + w * L / 2).epsilon(1e-9));
}

TEST_CASE("the forces of a line are the slopes of its energy, wherever its end is") {
    const double w = 30, L = 100, EA = 2e5;
    for (const bool ground : {false, true})
        for (const double across : {0.5, 20.0, 60.0, 90.0, 99.0, 110.0, 140.0})
            for (const double up : {-80.0, -3.0, 0.5, 20.0, 60.0, 99.0, 120.0}) {
                if (ground && up < 0) continue;
                CAPTURE(ground, across, up);
                const CatenaryLine line{L, EA, w, ground};
                const CatenaryShape s = hang(line, across, up);
                const double d = 1e-3;
                const double x =
                    (hang(line, across + d, up).energy - hang(line, across - d, up).energy) /
                    (2 * d);
                const double z =
                    (hang(line, across, up + d).energy - hang(line, across, up - d).energy) /
                    (2 * d);
                CHECK(s.across == Approx(x).epsilon(1e-5).margin(1e-3));
                CHECK(s.upper == Approx(z).epsilon(1e-5).margin(1e-3));
                // Its weight is held at both ends, and by the ground.
                CHECK(s.upper - s.lower == Approx(w * (L - s.resting)).epsilon(1e-9));
            }
}

TEST_CASE("a stiff line at the point of being taut") {
    const double w = 30, L = 100;
    for (const double EA : {1e6, 1e9, 1e12})
        for (const bool ground : {false, true})
            for (const double angle : {0.0, 0.01, 0.5, 1.5, 1.57})
                for (const double slack : {1e-2, 1e-5, 0.0, -1e-5, -1e-2}) {
                    CAPTURE(EA, ground, angle, slack);
                    const double distance = L * (1 - slack);
                    const CatenaryShape s = hang({L, EA, w, ground}, distance * std::cos(angle),
                                                 distance * std::sin(angle));
                    CHECK(s.upper - s.lower == Approx(w * (L - s.resting)).epsilon(1e-6));
                    if (slack < 0) CHECK(std::hypot(s.across, s.upper) > 0.99 * EA * -slack);
                }
}

TEST_CASE("whoever is below the ground has no line") {
    CHECK_THROWS_AS(hang({100, 1e6, 30, true}, 50, -1), MechanismError);
}
