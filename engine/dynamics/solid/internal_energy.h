// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"

namespace sphinx::dynamics::solid {

/// Elastic energy of a body: sum_i V_i W(F_i), and that of its hourglass control,
/// sum_i V_i c/2 sum_j k_ij abs(r_ij - F_i R_ij)^2 (deformation.h). Energy, zero at rest. Undamped
/// motion keeps it and the kinetic energy together.
template <int Dim>
double internalEnergy(Body<Dim>& body, Relations<Dim>& relations);

}  // namespace sphinx::dynamics::solid
