// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/fluid/terms/viscosity.h"

namespace sphinx::dynamics::fluid {

enum class WallSlip { no_slip, free_slip };

/// Viscous force, in one of two forms:
///   laplacian   dv_i/dt = 2 mu L / m_i sum_j v_ij / r_ij W' V_i V_j
///               Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776; L is
///               Kernel::laplacianFactor, which makes the sum exact on a lattice.
///   central     dv_i/dt = 2 (d + 2) mu / m_i sum_j (v_ij . e_ij) / r_ij  e_ij W' V_i V_j
///               guide (35) with the case's own dimension d.
/// Both conserve momentum and are 1/rho div(mu grad v) of an incompressible flow where neighbors
/// lie alike in all directions. They differ where they do not:
///   The laplacian needs no more than equal second moments, sum_j r_ij W' V_j e_ij (x) e_ij ~ 1.
///   Rows of particles that glide past each other have them, and so does any lattice. The central
///   sum needs equal fourth moments, which a shear flow does not leave: it lays the particles in
///   rows, and then the sum is that of 0.82 to 0.94 of mu (2D, h = 1.3 spacings, by the place of
///   one row to the next; 1.16 for shear along the diagonals of squares), at any spacing:
///   Poiseuille flow at L/20 is 13 % off, against 0.6 % with the laplacian. The central force
///   conserves angular momentum: fluid that turns as a rigid body feels nothing. Of the laplacian
///   that is true only away from the surface. At a free surface it makes the normal derivative of v
///   vanish, not the traction, and so slows a free round drop of radius R down at the rate 4 nu /
///   R^2.
/// The laplacian is the choice for flow along walls, central for free fluid that turns.
///
/// At a no-slip wall the velocity is continued linearly through the wall's surface:
/// v_ij = (v_i - v_w) (1 + d_j/d_i) with the distances of both particles from the surface; Morris,
/// Fox & Zhu 1997, (31)-(32).
///
/// Generalised Newtonian fluids: each particle has the viscosity mu_i at its shear rate sqrt(2 D:D)
/// (VelocityGradient), a pair the geometric mean of both (geometricMean() in terms/viscosity.h). A
/// particle of a wall has the fluidity 1/mu of the fluid, continued linearly, but no more viscosity
/// than there is in the fluid: with that of the fluid particle beside it, half a spacing from where
/// the wall drags, power-law flow at L/20 is 2.4 % off. div(2 mu D) has two parts: the laplacian
/// gives div(mu grad v), and vanishing as it does for a uniform mu, div(mu (grad v)^T) is missing.
/// It is added as the divergence of T = mu (L^T - tr(L) 1), which is that of an incompressible
/// flow, is zero for a uniform mu also where sound makes div v, and has no traction on a wall at
/// rest that the fluid sticks to: so it is summed over the fluid alone. The central sum has both
/// parts.
struct ViscousForceParameters {
    input::Name body;
    WallSlip wall = WallSlip::no_slip;
    ViscousForm form = ViscousForm::laplacian;
};

/// What a case may write for them.
inline auto wallSlips() {
    return input::choice<WallSlip>({
        {"no_slip", WallSlip::no_slip, "the fluid sticks to solids"},
        {"free_slip", WallSlip::free_slip, "solids exert no viscous force"},
    });
}
inline auto viscousForms() {
    return input::choice<ViscousForm>({
        {"laplacian", ViscousForm::laplacian, "exact in shear flow along walls"},
        {"central", ViscousForm::central,
         "guide (35): conserves angular momentum, for free fluid that turns; up to 18 % too weak "
         "in shear flow along walls"},
    });
}

}  // namespace sphinx::dynamics::fluid
