// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"

#include <string>

namespace sphinx::check {

/// Rows of particles across the thin places of an elastic body with those bonded to it. Of each
/// particle counts the shortest line of neighbors through it along an axis of the lattice, and of
/// all these numbers the one that a tenth of the particles stay within: the corners of a round
/// body are not its thickness. Particles that are fitted to a shape count along its normals.
template <int Dim>
std::size_t rowsAcross(const bodies::Body<Dim>& body);

/// How much farther than an exact one a beam of so many rows of that body bends, of it; below 0 it
/// is stiff. A fit of what was measured (dynamics/solid/README.md) with the smoothing ratio and
/// Poisson's ratio of the body; with hourglass control.
template <int Dim>
double bendingError(std::size_t rows, const bodies::Body<Dim>& body);

/// "4 rows across: bending about 20 % soft"
std::string bendingText(std::size_t rows, double error);

}  // namespace sphinx::check
