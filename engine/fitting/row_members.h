// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"
#include "particles/lattice.h"

#include <cstdint>
#include <vector>

namespace sphinx::fitting {

/// Which of the points, of that volume each, become the row at the surface: of those less than 1.6
/// spacings deep as many as the layer of one spacing at the surface measures, on each of several
/// surfaces by itself. Of the places on the row to which the points are nearest the most crowded is
/// left out, again and again (Yuksel 2015, Computer Graphics Forum 34(2)), and of two alike the
/// deeper one. So the row is as dense everywhere, whichever way the surface runs through the
/// lattice. Of those that a symmetry of the shape does not tell apart all are left out or none, if
/// the number is right to half a percent all the same.
template <int Dim>
std::vector<std::uint8_t> rowMembers(const geometry::Shape<Dim>& shape,
                                     const particles::Lattice<Dim>& lattice,
                                     const std::vector<Vec<Dim>>& points, double volume);

}  // namespace sphinx::fitting
