// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::check {

/// Warns of solids through which a fluid that sees them may leak: rigid ones of fewer than three
/// layers of particles, and any with a coarser spacing than the fluid; and of rigid bodies that
/// nothing sees.
template <int Dim>
void checkWalls(const model::Case& model, const bodies::World<Dim>& world,
                input::Diagnostics& diagnostics);

}  // namespace sphinx::check
