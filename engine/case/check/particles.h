// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <string>

namespace sphinx::model {

/// Reports lattices too large to be made.
template <int Dim>
void checkLattices(const Case& model, input::Diagnostics& diagnostics);

/// Reports bodies without particles, bodies that overlap, fluid outside of the domain and initial
/// values that are no numbers.
template <int Dim>
void checkParticles(const Case& model, const World<Dim>& world, input::Diagnostics& diagnostics);

}  // namespace sphinx::model
