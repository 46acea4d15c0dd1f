// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/viscous_force.h"

namespace sphinx::dynamics::fluid {

/// The viscous force of fluid.viscous_force, at the velocities at the end of an acoustic step: for
/// any step, however large against h^2/nu. It stands between the halves of
/// fluid.pressure_relaxation: what the first half has made of the velocities, v*, is by pressure
/// and outer forces, and
///   v = v* + dt F(v)/m,  F linear in v,
/// is solved by conjugate gradients. So at rest, and in any steady flow, pressure, outer forces and
/// viscosity balance exactly, for any step; implicit_viscosity.md has the analysis.
///
/// The solution x of which the solver has a residual z = v* + dt F(x)/m - x is left as x + z =
/// v* + dt F(x)/m: what is gained is the sum of pair forces, which cancel, and what solids get is
/// minus what the fluid has felt of them, however well it is solved. z has been found with the
/// numbers that moved x, so no rounding of F is multiplied by dt.
struct ImplicitViscosityParameters {
    input::Name body;
    WallSlip wall = WallSlip::no_slip;
    ViscousForm form = ViscousForm::laplacian;
    double tolerance = 1e-4;  ///< rms of z by that of v*
    int most_iterations = 1000;

    ViscousForceParameters force() const { return {body, wall, form}; }
};

}  // namespace sphinx::dynamics::fluid
