// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/build/lattices.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <map>
#include <memory>
#include <string>

namespace sphinx::build {

/// Bodies with their particles and initial values. What only shows on particles goes to
/// `diagnostics`: a body without particles, bodies that overlap, fluid outside of the domain.
/// Without `particles` the bodies stay empty, for a restart to fill. `lattices`, if given, gets
/// where the lattices of the bodies lie, by name, without their points.
template <int Dim>
std::unique_ptr<bodies::World<Dim>> buildWorld(
    const model::Case& model, bool particles, input::Diagnostics& diagnostics,
    std::map<std::string, PlacedLattice<Dim>>* lattices = nullptr);

}  // namespace sphinx::build
