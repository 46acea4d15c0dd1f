// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"

#include <cstdint>
#include <vector>

namespace sphinx::fitting {

/// Which of the points become the row at the surface: `number` of those less than 1.6 spacings
/// deep, or as near to it as leaves out all or none of those that a symmetry of the shape does not
/// tell apart (up to one in a hundred). Of all places on the row to which those points are nearest
/// the most crowded is left out, again and again (Yuksel 2015, doi:10.1111/cgf.12538), and of two
/// alike the deeper one. So the row is as dense everywhere: on each of several surfaces, and
/// whichever way they run through the lattice.
template <int Dim>
std::vector<std::uint8_t> rowMembers(const geometry::Shape<Dim>& shape, double spacing,
                                     const std::vector<Vec<Dim>>& points, double number);

}  // namespace sphinx::fitting
