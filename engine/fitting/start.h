// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"
#include "particles/lattice.h"

#include <cstdint>
#include <vector>

namespace sphinx::fitting {

template <int Dim>
struct Start {
    std::vector<Vec<Dim>> points;
    std::vector<std::uint8_t> in_row;  ///< of the surface
    double volume = 0;                 ///< of each
};

/// The points of a lattice that lie deepest in a shape, as many as the shape measures cells, and of
/// them as many for the row at the surface as the layer of one spacing there measures. Of points
/// that lie as deep all are taken or none where the number is right to half a percent all the same,
/// so that a mirrored shape has mirrored points; else (a row of a rectangle lies as deep) those
/// nearest to the middle of the bounds.
template <int Dim>
Start<Dim> startOf(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice);

}  // namespace sphinx::fitting
