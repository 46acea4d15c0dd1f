// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "geometry/shape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sphinx::particles {

/// Square (cubic) lattice. Its points lie at origin + (k + 1/2) spacing, so a face at origin + k
/// spacing lies half a spacing from them.
template <int Dim>
struct Lattice {
    double spacing = 0;
    Vec<Dim> origin = Vec<Dim>::Zero();
};

/// Points of the lattice inside a shape, x fastest. A point on the surface, to rounding, belongs to
/// the shape where the shape goes on towards larger coordinates: of shapes that share a face or an
/// edge, to one only.
template <int Dim>
std::vector<Vec<Dim>> latticePoints(const geometry::Shape<Dim>& shape, const Lattice<Dim>& lattice);

/// Number of a lattice point along each axis.
template <int Dim>
using LatticeIndex = std::array<long, Dim>;

/// Points of a lattice on the surface of a shape, to rounding.
template <int Dim>
struct SurfacePoints {
    /// Those on faces normal to an axis, by axis: where the shape lies above, and where below.
    std::array<std::vector<LatticeIndex<Dim>>, Dim> lower, upper;
    std::size_t count = 0;  ///< those on oblique faces and on edges as well
};

template <int Dim>
SurfacePoints<Dim> surfacePoints(const geometry::Shape<Dim>& shape, const Lattice<Dim>& lattice);

/// Both, by one look at the shape.
template <int Dim>
struct LatticeScan {
    std::vector<Vec<Dim>> points;  ///< latticePoints()
    SurfacePoints<Dim> surface;    ///< surfacePoints()
};

template <int Dim>
LatticeScan<Dim> scanLattice(const geometry::Shape<Dim>& shape, const Lattice<Dim>& lattice);

}  // namespace sphinx::particles
