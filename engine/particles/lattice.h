// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "geometry/shape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sphinx::particles {

/// Points of the square (cubic) lattice inside a shape, x fastest. Lattice lines run at
/// origin + (k + 1/2) spacing, so a face at origin + k spacing lies half a spacing from the points.
template <int Dim>
std::vector<Vec<Dim>> latticePoints(const geometry::Shape<Dim>& shape, double spacing,
                                    const Vec<Dim>& origin);

}  // namespace sphinx::particles
