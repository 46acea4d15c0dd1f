// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/fluid_laws.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace sphinx;
using namespace sphinx::materials;

TEST_CASE("power law by hand") {
    // 0.5 Pa s at 2/s, and 0.5 (8/2)^(-1/2) at 8/s.
    const PowerLawFluid fluid({1, 10, 0.5, 0.5, 2, 1e-6});
    CHECK(fluid.viscosityAt(2) == Approx(0.5).epsilon(1e-12));
    CHECK(fluid.viscosityAt(8) == Approx(0.25).epsilon(1e-12));
    // At rest that of the regularisation rate, which is what the material says it is.
    CHECK(fluid.viscosityAt(0) == Approx(0.5 * std::pow(0.5e-6, -0.5)).epsilon(1e-12));
    CHECK(fluid.viscosity() == fluid.viscosityAt(0));
    // The stress is off by (n - 1)/2 (gamma_0/gamma)^2.
    const PowerLawFluid thick({1, 10, 0.5, 1.5, 2, 0.02});
    const double rate = 2;
    CHECK(thick.viscosityAt(rate) / 0.5 - 1 == Approx(0.25 * 1e-4).epsilon(1e-3));
}

TEST_CASE("Carreau by hand") {
    const CarreauFluid fluid({1, 10, 5, 1, 2, 0});
    CHECK(fluid.viscosityAt(0) == 5);
    // lambda gamma = sqrt(3): half of the way.
    CHECK(fluid.viscosityAt(std::sqrt(3.0) / 2) == Approx(3).epsilon(1e-12));
    CHECK(fluid.viscosityAt(1e9) == Approx(1).epsilon(1e-6));
}

TEST_CASE("Herschel-Bulkley by hand") {
    // tau = 3 + 2 gamma^0.5 once yielded; the yield rate is that of 2 gamma^0.5 = 3.
    const HerschelBulkleyParameters p{1, 10, 3, 2, 0.5, 1, {}};
    CHECK(p.yieldRate() == Approx(2.25).epsilon(1e-12));
    const HerschelBulkleyFluid fluid(p);
    CHECK(4 * fluid.viscosityAt(4) == Approx(3 + 4).epsilon(1e-4));
    const double least = 0.0225;
    CHECK(fluid.viscosityAt(0) == Approx(3 / least + 2 / std::sqrt(least)).epsilon(1e-9));
    // One e-fold from rest.
    CHECK(fluid.viscosityAt(least) ==
          Approx(3 / least * (1 - std::exp(-1.0)) + 2 / std::sqrt(std::sqrt(2.0) * least)));
    HerschelBulkleyParameters coarse = p;
    coarse.regularisation_rate = 1;
    CHECK(HerschelBulkleyFluid(coarse).viscosityAt(0) == Approx(3 + 2).epsilon(1e-9));
}

TEST_CASE("the pressure of all of them is linear in the density") {
    const OldroydBFluid polymers({1000, 20, 0.1, 0.9, 3});
    CHECK(polymers.modulus() == Approx(0.3));
    CHECK(polymers.viscosity() == 0.1);
    const double p = withLaw(polymers, [](const auto& law) { return law.pressure(1010); });
    CHECK(p == Approx(400 * 10).epsilon(1e-14));
    CHECK(asOldroydB(polymers) == &polymers);
    CHECK(asGeneralisedNewtonian(polymers) == nullptr);
}
