// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/wide.h"
#include "input/declaration/registry.h"
#include "materials/linear_pressure.h"

#include <cmath>
#include <memory>
#include <optional>

namespace sphinx::materials {

enum class EquationOfState { linear, tait };

struct WeaklyCompressibleFluidParameters {
    double density = 0;      ///< rho0, mass/length^3
    double sound_speed = 0;  ///< c0, length/time
    double viscosity = 0;    ///< dynamic viscosity mu, mass/(length time)
    EquationOfState equation_of_state = EquationOfState::linear;
    std::optional<double> gamma;  ///< exponent of the Tait equation; without: 7
};

/// p = c0^2 (rho - rho0), guide below (19).
class LinearFluid final : public LinearPressure {
 public:
    using LinearPressure::LinearPressure;
};

/// p = rho0 c0^2 / gamma ((rho/rho0)^gamma - 1), Monaghan 1994, doi:10.1006/jcph.1994.1034.
class TaitFluid final : public Fluid {
 public:
    /// gamma: above 0; 1 is the linear law.
    TaitFluid(double density, double sound_speed, double viscosity, double gamma)
        : Fluid(density, sound_speed, viscosity), gamma_(gamma) {}

    double pressure(double rho) const { return pressureAt(rho); }
    Wide pressure(Wide rho) const { return pressureAt(rho); }
    double densityAt(double p) const {
        return density() * std::pow(1 + gamma_ * p / (density() * c2_), 1 / gamma_);
    }
    double internalEnergy(double rho) const {
        const double x = rho / density();
        return c2_ / gamma_ * ((std::pow(x, gamma_ - 1) - 1) / (gamma_ - 1) + 1 / x - 1);
    }

 private:
    template <class Number>
    Number pressureAt(Number rho) const {
        using std::pow;
        return density() * c2_ / gamma_ * (pow(rho / density(), gamma_) - 1);
    }

    double c2_ = soundSpeed() * soundSpeed();
    double gamma_;
};

/// The law that the parameters ask for.
std::shared_ptr<const Fluid> makeFluid(const WeaklyCompressibleFluidParameters& parameters);

/// Registers weakly_compressible_fluid.
void declareWeaklyCompressibleFluid(input::Registry& registry);

}  // namespace sphinx::materials
