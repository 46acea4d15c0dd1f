// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fsi/fluid_force.h"

namespace sphinx::dynamics::fsi {

/// Registers fsi.viscous_force.
void declareViscousForce(input::Registry& registry);

}  // namespace sphinx::dynamics::fsi
