// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/build/lattices.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <string>

namespace sphinx::build {

/// Fits the points of a body whose arrangement is relaxed to its shape, from where its lattice
/// lies. Reports a shape that is too thin for that, or reaches across a periodic side, and warns
/// where the points have not come to rest.
template <int Dim>
void relaxPoints(const model::Body& source, const bodies::Body<Dim>& body,
                 const bodies::World<Dim>& world, PlacedLattice<Dim>& placed,
                 input::Diagnostics& diagnostics);

/// "relaxed in 212 steps to a residual of 0.0049, 124 in the row at the surface"
template <int Dim>
std::string relaxedText(const fitting::Relaxed<Dim>& relaxed);

}  // namespace sphinx::build
