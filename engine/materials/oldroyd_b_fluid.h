// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "materials/linear_pressure.h"

namespace sphinx::materials {

struct OldroydBParameters {
    double density = 0;            ///< rho0, mass/length^3
    double sound_speed = 0;        ///< c0, length/time
    double solvent_viscosity = 0;  ///< eta_s, mass/(length time)
    double polymer_viscosity = 0;  ///< eta_p, that the polymers add to it in a slow flow
    double relaxation_time = 0;    ///< lambda, time
};

/// Newtonian solvent with dissolved polymers, Oldroyd 1950, doi:10.1098/rspa.1950.0035; guide (20):
/// tau = 2 eta_s D + tau_p, and of the conformation c of the polymers, which is 1 at rest,
/// tau_p = eta_p/lambda (c - 1). How c changes: dynamics/fluid/polymer_stress.cpp.
class OldroydBFluid final : public LinearPressure {
 public:
    explicit OldroydBFluid(const OldroydBParameters& p)
        : LinearPressure(p.density, p.sound_speed, p.solvent_viscosity),
          polymer_viscosity_(p.polymer_viscosity),
          relaxation_time_(p.relaxation_time) {}
    double polymerViscosity() const { return polymer_viscosity_; }
    double relaxationTime() const { return relaxation_time_; }
    /// eta_p/lambda, a pressure.
    double modulus() const { return polymer_viscosity_ / relaxation_time_; }

 private:
    double polymer_viscosity_;
    double relaxation_time_;
};

/// nullptr where it has no polymers.
inline const OldroydBFluid* asOldroydB(const Fluid& fluid) {
    return dynamic_cast<const OldroydBFluid*>(&fluid);
}

/// Registers oldroyd_b_fluid.
void declareOldroydB(input::Registry& registry);

}  // namespace sphinx::materials
