// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <string>

namespace sphinx::check {

/// Reports lattices too large to be made.
template <int Dim>
void checkLattices(const model::Case& model, input::Diagnostics& diagnostics);

/// Reports bodies without particles, bodies that overlap, fluid outside of the domain and initial
/// values that are no numbers.
template <int Dim>
void checkParticles(const model::Case& model, const bodies::World<Dim>& world,
                    input::Diagnostics& diagnostics);

}  // namespace sphinx::check
