// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/material.h"

#include <cmath>
#include <optional>

namespace sphinx {

enum class EquationOfState { linear, tait };

/// Weakly compressible fluid.
/// linear: p = c0^2 (rho - rho0), guide below (19).
/// tait:   p = rho0 c0^2 / gamma ((rho/rho0)^gamma - 1), Monaghan 1994, doi:10.1006/jcph.1994.1034.
class WeaklyCompressibleFluid final : public Material {
 public:
    struct Parameters {
        double density = 0;      ///< rho0, mass/length^3
        double sound_speed = 0;  ///< c0, length/time
        double viscosity = 0;    ///< dynamic viscosity mu, mass/(length time)
        EquationOfState equation_of_state = EquationOfState::linear;
        std::optional<double> gamma;  ///< exponent of the Tait equation; without: 7
    };

    explicit WeaklyCompressibleFluid(const Parameters& p) : p_(p), gamma_(p.gamma.value_or(7)) {}

    double density() const override { return p_.density; }
    double soundSpeed() const { return p_.sound_speed; }
    double viscosity() const { return p_.viscosity; }
    EquationOfState equationOfState() const { return p_.equation_of_state; }

    double pressure(double rho) const {
        const double c2 = p_.sound_speed * p_.sound_speed;
        if (p_.equation_of_state == EquationOfState::linear) return c2 * (rho - p_.density);
        return p_.density * c2 / gamma_ * (std::pow(rho / p_.density, gamma_) - 1);
    }
    /// Inverse of pressure().
    double densityAt(double p) const {
        const double c2 = p_.sound_speed * p_.sound_speed;
        if (p_.equation_of_state == EquationOfState::linear) return p_.density + p / c2;
        return p_.density * std::pow(1 + gamma_ * p / (p_.density * c2), 1 / gamma_);
    }
    /// Internal energy per mass: the integral of p/rho^2 from rho0 to rho.
    double internalEnergy(double rho) const {
        const double c2 = p_.sound_speed * p_.sound_speed;
        const double x = rho / p_.density;
        if (p_.equation_of_state == EquationOfState::linear) return c2 * (std::log(x) + 1 / x - 1);
        const double g = gamma_;
        return c2 / g * ((std::pow(x, g - 1) - 1) / (g - 1) + 1 / x - 1);
    }

 private:
    Parameters p_;
    double gamma_;
};

}  // namespace sphinx
