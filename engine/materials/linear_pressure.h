// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/wide.h"
#include "materials/fluid.h"

#include <cmath>

namespace sphinx::materials {

/// What fluids have in common of which the pressure is linear in the density: p = c0^2 (rho -
/// rho0).
class LinearPressure : public Fluid {
 public:
    using Fluid::Fluid;

    double pressure(double rho) const { return c2_ * (rho - density()); }
    Wide pressure(Wide rho) const { return c2_ * (rho - density()); }
    double densityAt(double p) const { return density() + p / c2_; }
    double internalEnergy(double rho) const {
        const double x = rho / density();
        return c2_ * (std::log(x) + 1 / x - 1);
    }

 private:
    double c2_ = soundSpeed() * soundSpeed();
};

}  // namespace sphinx::materials
