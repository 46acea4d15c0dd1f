// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::model {

/// What loads and constraints ask of the particles that they act on: a prescribed displacement is
/// zero at the start, a surface that carries a pressure has a normal, and a clamp leaves some free.
template <int Dim>
void checkLoads(const Case& model, const World<Dim>& world, input::Diagnostics& diagnostics);

}  // namespace sphinx::model
