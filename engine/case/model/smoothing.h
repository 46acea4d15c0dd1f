// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/role.h"
#include "kernels/kernel.h"

namespace sphinx::model {

// The kernel of a body, and its smoothing length over spacing, h / dp, where neither it nor the
// case states them. Fluids, and the bodies that they see: the quintic spline at 1, for which a
// lattice of particles under pressure bears no shear, as a fluid does (dynamics/fluid/
// free_surface.md); of the other kernels the ratio at which it bears the least. Elastic bodies:
// Wendland C2 at the ratio at which beams of few rows of particles bend, swing and twist with the
// least error (dynamics/solid/README.md).

/// `has_ratio`: a ratio is stated without a kernel. It is one of Wendland C2, whose 1.3 to 1.5
/// everybody states.
kernels::KernelType defaultKernel(bodies::Role role, bool has_ratio);
double defaultSmoothingRatio(bodies::Role role, kernels::KernelType kernel);

}  // namespace sphinx::model
