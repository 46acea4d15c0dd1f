// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

/// Of a hundred particles one has the speed 5 and the others that of 1.
template <int Dim>
struct Moving : Scene<Dim> {
    explicit Moving(double viscosity)
        : water(this->fluid("water", std::vector<Vec<Dim>>(100, Vec<Dim>::Zero()),
                            {.viscosity = viscosity})) {
        for (int i = 0; i < 100; ++i) velocity[i] = Vec<Dim>::Unit(i % Dim);
        velocity[42].setZero();
        velocity[42].template tail<2>() = Vec<2>(3, -4);
    }
    auto advection(double reference_speed) {
        return this->timeStep(fmt::format(
            "type: fluid.advection_time_step, body: water, reference_speed: {}", reference_speed));
    }
    Body<Dim>& water;
    Field<Vec<Dim>>& velocity = water.particles.vector(fields::velocity);
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("acoustic time step of a fluid, guide (53)", "", ((int Dim), Dim), 2, 3) {
    Moving<Dim> scene(0.3);
    const auto step = scene.timeStep("type: fluid.acoustic_time_step, body: water");
    const double h = scene.water.kernel.smoothingLength();
    const double cfl = Dim == 2 ? 0.69 : 0.6;
    CHECK(step->estimate() == Approx(cfl * h / (10 + 5)).epsilon(1e-14));
    scene.velocity.setZero();
    CHECK(step->estimate() == Approx(cfl * h / 10).epsilon(1e-14));
    const auto half = scene.timeStep("type: fluid.acoustic_time_step, body: water, cfl: 0.3");
    CHECK(half->estimate() == Approx(0.3 * h / 10).epsilon(1e-14));
}

TEMPLATE_TEST_CASE_SIG("advection time step, guide (52)", "", ((int Dim), Dim), 2, 3) {
    // Inviscid: by the largest speed, and by that of reference where it is larger.
    Moving<Dim> inviscid(0);
    const double h = inviscid.water.kernel.smoothingLength();
    const auto step = inviscid.advection(2);
    CHECK(step->estimate() == Approx(0.25 * h / 5).epsilon(1e-14));
    CHECK(inviscid.advection(8)->estimate() == Approx(0.25 * h / 8).epsilon(1e-14));
    inviscid.velocity.setZero();
    CHECK(step->estimate() == Approx(0.25 * h / 2).epsilon(1e-14));

    // Viscous: nu = mu/rho0 counts from nu = 5 h.
    for (const double share : {0.5, 2.0}) {
        const double nu = share * 5 * h;
        Moving<Dim> viscous(density * nu);
        CHECK(viscous.advection(2)->estimate() ==
              Approx(0.25 * (share > 1 ? h * h / nu : h / 5)).epsilon(1e-14));
    }
}
