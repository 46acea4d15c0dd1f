// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/fluid_laws.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

using namespace sphinx;
using namespace sphinx::materials;

namespace {

constexpr double rho0 = 1000;
constexpr double c0 = 20;

LinearFluid linearFluid() { return {rho0, c0, 0}; }
TaitFluid taitFluid(double gamma = 7) { return {rho0, c0, 0, gamma}; }

}  // namespace

TEST_CASE("equations of state by hand") {
    const LinearFluid linear = linearFluid();
    CHECK(linear.pressure(1010) == Approx(400 * 10).epsilon(1e-14));
    CHECK(linear.pressure(990) == Approx(-400 * 10).epsilon(1e-14));
    CHECK(linear.densityAt(4000) == Approx(1010).epsilon(1e-14));
    // B = rho0 c0^2/7, and 1.1^7 = 1.9487171.
    const TaitFluid tait = taitFluid();
    CHECK(tait.pressure(1100) == Approx(4e5 / 7 * 0.9487171).epsilon(1e-14));
    CHECK(tait.pressure(Wide(1100.0))[7] == tait.pressure(1100));
    CHECK(tait.densityAt(4e5 / 7 * 0.9487171) == Approx(1100).epsilon(1e-14));
    // With the exponent 1 it is the linear one.
    const TaitFluid straight = taitFluid(1);
    CHECK(straight.pressure(1010) == Approx(4000).epsilon(1e-12));
    CHECK(straight.densityAt(4000) == Approx(1010).epsilon(1e-12));
}

TEST_CASE("pressure, its inverse, the speed of sound and the internal energy agree") {
    const std::size_t number = GENERATE(0, 1, 2);
    const std::array<std::shared_ptr<const Fluid>, 3> fluids{
        std::make_shared<LinearFluid>(linearFluid()), std::make_shared<TaitFluid>(taitFluid()),
        std::make_shared<TaitFluid>(taitFluid(1.4))};
    withLaw(*fluids[number], [](const auto& f) {
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
    });
}

TEST_CASE("a fluid gets the law that its parameters ask for") {
    WeaklyCompressibleFluidParameters p;
    p.density = rho0;
    p.sound_speed = c0;
    const auto pressure = [&] {
        return withLaw(*makeFluid(p), [](const auto& law) { return law.pressure(1100); });
    };
    CHECK(pressure() == linearFluid().pressure(1100));
    p.equation_of_state = EquationOfState::tait;
    CHECK(pressure() == taitFluid().pressure(1100));
    p.gamma = 1.4;
    CHECK(pressure() == taitFluid(1.4).pressure(1100));
}
