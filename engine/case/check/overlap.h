// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::check {

/// Reports bodies of which particles lie nearer than half a spacing to each other, and whether that
/// is because their shapes overlap or because a lattice does not end at the surface of its shape.
template <int Dim>
void checkOverlap(const model::Case& model, const bodies::World<Dim>& world,
                  input::Diagnostics& diagnostics);

}  // namespace sphinx::check
