// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

TEMPLATE_TEST_CASE_SIG("mean of the pressure over the substeps of an interval", "",
                       ((int Dim), Dim), 2, 3) {
    Scene<Dim> scene;
    Body<Dim>& water = scene.fluid("water", scene.lattice(2));
    auto& particles = water.particles;
    auto& pressure = particles.scalar(fields::pressure);
    const auto setPressure = [&](double scale) {
        for (std::size_t i = 0; i < particles.size(); ++i)
            pressure[i] = scale * static_cast<double>(i + 1);
    };
    setPressure(7);
    const auto average = scene.method("type: fluid.average_pressure, body: water");
    auto& mean = particles.scalar(fields::average_pressure);
    const auto isTimes = [&](double scale) {
        for (std::size_t i = 0; i < particles.size(); ++i)
            if (mean[i] != Approx(scale * static_cast<double>(i + 1))) return false;
        return true;
    };
    CHECK(isTimes(7));  // before any step

    Clock clock;
    const auto substep = [&](double dt, double scale) {
        clock.dt = dt;
        setPressure(scale);
        average.run(clock);
        clock.time += dt;
    };
    substep(0.1, 2);
    CHECK(isTimes(2));
    substep(0.3, -4);
    CHECK(isTimes((0.1 * 2 - 0.3 * 4) / 0.4));
    substep(0.2, 1);
    CHECK(isTimes((0.1 * 2 - 0.3 * 4 + 0.2 * 1) / 0.6));
    clock.interval_start = clock.time;
    substep(0.2, 5);
    CHECK(isTimes(5));
    substep(0.2, 3);
    CHECK(isTimes(4));
}
