// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/density_summation.h"

namespace sphinx::dynamics::fluid {

/// Transport velocity, Adami, Hu & Adams 2013, doi:10.1016/j.jcp.2013.01.043; guide (40),
/// (48)-(51): particles move with v~ = v + s/dt, s the shift by which a pressure that is the same
/// everywhere would even out their arrangement in a step,
///   s_i = -0.3 dp^2 sum_j e_ij W' V_j,
/// over the fluid, the solids and the other fluids that it sees, dp the spacing. What the momentum
/// is carried along by the shift is the extra stress of (50), A = rho v (x) (v~ - v):
///   dv_i = 1/m_i sum_j (A_i + A_j) . e_ij W' V_i V_j dt,   A_i dt = rho_i v_i (x) s_i.
/// v is taken relative to the mean of the fluid, so that a flow that is carried along is the same
/// flow; solids do not shift, so their A is 0. Momentum is kept. Nothing is carried from one fluid
/// to another: the shift leaves no gap and fills none between them, so it does not cross the
/// interface.
///
/// The shift is that of a step of whatever length: a background pressure p_b of 0.15 rho (dp/dt)^2,
/// which nobody has to choose. By the eigenvalues of its linear form over the waves of a lattice
/// (dp^2 sum_j V_j grad grad W (1 - cos k . r) is at most 1.2 to 1.7 for the customary kernels and
/// ratios) it takes 0.36 to 0.5 of the disorder that it finds in the shortest waves, and would
/// swing beyond a factor of 1.2.
///
/// `surface: free`: what a surface cuts off a part of the neighborhood of (Support) is not shifted,
/// else the fluid would spread into the open.
struct TransportVelocityParameters {
    input::Name body;
    Surface surface = Surface::confined;
};

}  // namespace sphinx::dynamics::fluid
