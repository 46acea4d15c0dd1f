// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/mechanism.h"
#include "dynamics/multibody/parameters.h"
#include "dynamics/words.h"
#include "input/tree/diagnostics.h"

namespace sphinx::dynamics::multibody {

/// The mechanism that the block describes, with the masses of the particles of the world. Mistakes
/// are reported; then the description means nothing. A body that is child of no joint is free.
template <int Dim>
MechanismDescription describe(const MultibodyParameters& parameters, const World<Dim>& world,
                              input::Diagnostics& diagnostics);

}  // namespace sphinx::dynamics::multibody
