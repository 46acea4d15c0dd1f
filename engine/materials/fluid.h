// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/material.h"

namespace sphinx::materials {

/// Fluid whose pressure follows from its density. What depends on the density are members of the
/// final classes, reached through withLaw() of fluid_laws.h:
///
///     double pressure(double rho) const;
///     double densityAt(double p) const;         // the inverse of pressure()
///     double internalEnergy(double rho) const;  // per mass: the integral of p/rho^2 from rho0
class Fluid : public Material {
 public:
    /// Density at zero pressure in mass/length^3, speed of sound there in length/time, dynamic
    /// viscosity in mass/(length time).
    Fluid(double density, double sound_speed, double viscosity)
        : density_(density), sound_speed_(sound_speed), viscosity_(viscosity) {}

    double density() const override { return density_; }
    double soundSpeed() const { return sound_speed_; }
    /// That of a Newtonian fluid; of a generalised Newtonian one at rest, of one with polymers that
    /// of the solvent.
    double viscosity() const { return viscosity_; }

 private:
    double density_;
    double sound_speed_;
    double viscosity_;
};

}  // namespace sphinx::materials
