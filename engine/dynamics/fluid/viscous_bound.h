// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/terms/viscosity.h"
#include "dynamics/words.h"

#include <vector>

namespace sphinx::dynamics::fluid {

/// How fast the viscous force changes velocities at most: eigenvalues of the sum of pairs on a
/// square (cubic) lattice, divided by the kinematic viscosity, 1/length^2. A step of size dt is
/// stable for dt nu lambda <= 2.
///   whole   the largest: among the plane waves of an endless lattice, and where it ends at no-slip
///           walls half a spacing away, which meet at right angles. There it is the sum of a row,
///           twice the terms with the fluid and those with the walls; with the laplacian by 1.11,
///           by 1.05 where h is more than 1.5 spacings: eigenvalues of the particles in boxes, 6^3
///           and 10^2, are below that. Velocities continued into a wall make its terms the larger
///           ones.
///   walls   what walls have in it. A solid of density rho_s that the force pushes has the same
///           terms over rho_s.
/// In h^2/nu, largest stable steps with Wendland C2 at h = 1.3 spacings: 0.31 in a plain lattice,
/// 0.26 along a wall and 0.24 in a corner in 2D, 0.29, 0.24 and 0.20 in 3D; with the quintic spline
/// at h = 1 0.52, 0.43, 0.41, and 0.50, 0.40, 0.34; with `central` less than a half of that.
struct ViscousBound {
    double whole = 0;
    double walls = 0;
};

/// `walls`: solids that the fluid sticks to.
template <int Dim>
ViscousBound viscousBound(const Body<Dim>& fluid, ViscousForm form,
                          const std::vector<const Body<Dim>*>& walls);

}  // namespace sphinx::dynamics::fluid
