// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"
#include "kernels/kernel.h"
#include "particles/lattice.h"

#include <optional>
#include <vector>

/// Particles fitted to shapes.
namespace sphinx::fitting {

/// When to end.
struct RelaxLimits {
    /// Largest force that moves a particle, in parts of what the missing half of its neighbors
    /// would make at a plane surface.
    double residual = 5e-3;
    int steps = 2000;
};

template <int Dim>
struct Relaxed {
    std::vector<Vec<Dim>> points;
    double volume = 0;    ///< of each
    int steps = 0;        ///< that were made
    double residual = 0;  ///< as in RelaxLimits, at the end
    bool converged = false;
    std::size_t row = 0;  ///< points in the row at the surface
    /// Of a point of that row which is less than two fifths of a spacing deep: there the shape is
    /// thinner than a spacing.
    std::optional<Vec<Dim>> thin;
};

/// Particles of one volume in a shape, the row at the surface half a spacing inside, by relaxation:
/// from points of a lattice they move down the gradient of their kernel sums, which is that of a
/// constant pressure, as in Zhu, Zhang, Yu & Hu 2021, Journal of Hydrodynamics 33(2). The row has
/// as many as there is volume less than a spacing deep; it stays on the surface half a spacing
/// below that of the shape, and all others a spacing below it or deeper. So their density is the
/// same everywhere, which it is not if the pressure alone decides who gets into the row.
///
/// The places have the same bits on any number of threads; those of a shape that is mirrored in a
/// plane through the lattice's origin are mirrored.
template <int Dim>
Relaxed<Dim> relax(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                   const kernels::Kernel<Dim>& kernel, const RelaxLimits& limits = {});

}  // namespace sphinx::fitting
