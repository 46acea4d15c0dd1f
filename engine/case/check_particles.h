// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model.h"
#include "input/diagnostics.h"

namespace sphinx::model {

/// Reports bodies without particles, bodies that overlap and fluid outside of the domain.
template <int Dim>
void checkParticles(const Case& model, const World<Dim>& world, input::Diagnostics& diagnostics);

}  // namespace sphinx::model
