// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/fluid.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;

namespace {

constexpr double rho0 = 1000;
constexpr double c0 = 20;

WeaklyCompressibleFluid fluid(EquationOfState equation, double gamma = 7) {
    WeaklyCompressibleFluid::Parameters p;
    p.density = rho0;
    p.sound_speed = c0;
    p.equation_of_state = equation;
    p.gamma = gamma;
    return WeaklyCompressibleFluid(p);
}

}  // namespace

TEST_CASE("equations of state by hand") {
    const WeaklyCompressibleFluid linear = fluid(EquationOfState::linear);
    CHECK(linear.pressure(1010) == Approx(400 * 10).epsilon(1e-14));
    CHECK(linear.pressure(990) == Approx(-400 * 10).epsilon(1e-14));
    CHECK(linear.densityAt(4000) == Approx(1010).epsilon(1e-14));
    // B = rho0 c0^2/7, and 1.1^7 = 1.9487171.
    const WeaklyCompressibleFluid tait = fluid(EquationOfState::tait);
    CHECK(tait.pressure(1100) == Approx(4e5 / 7 * 0.9487171).epsilon(1e-14));
    CHECK(tait.densityAt(4e5 / 7 * 0.9487171) == Approx(1100).epsilon(1e-14));
    // With the exponent 1 it is the linear one.
    const WeaklyCompressibleFluid straight = fluid(EquationOfState::tait, 1);
    CHECK(straight.pressure(1010) == Approx(4000).epsilon(1e-12));
    CHECK(straight.densityAt(4000) == Approx(1010).epsilon(1e-12));
}

TEST_CASE("pressure, its inverse, the speed of sound and the internal energy agree") {
    for (const WeaklyCompressibleFluid& f :
         {fluid(EquationOfState::linear), fluid(EquationOfState::tait),
          fluid(EquationOfState::tait, 1.4)}) {
        CHECK(f.pressure(rho0) == 0);
        CHECK(f.densityAt(0) == rho0);
        CHECK(f.internalEnergy(rho0) == 0);
        const auto slope = [](auto&& g, double x) {
            const double step = 1e-5 * x;
            return (g(x + step) - g(x - step)) / (2 * step);
        };
        // dp/drho = c0^2 at rho0.
        CHECK(slope([&](double rho) { return f.pressure(rho); }, rho0) ==
              Approx(c0 * c0).epsilon(1e-8));
        for (double rho = 0.8 * rho0; rho < 1.25 * rho0; rho += 0.05 * rho0) {
            INFO("density " << rho);
            CHECK(f.densityAt(f.pressure(rho)) == Approx(rho).epsilon(1e-13));
            // de/drho = p/rho^2.
            CHECK(slope([&](double r) { return f.internalEnergy(r); }, rho) ==
                  Approx(f.pressure(rho) / (rho * rho)).epsilon(1e-6).margin(1e-9));
        }
    }
}
