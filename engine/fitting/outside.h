// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "geometry/shape.h"
#include "particles/lattice.h"

#include <vector>

namespace sphinx::fitting {

/// What lies around a shape, in pieces: the cells of the lattice that lie wholly outside, and of
/// those at the surface that part of each of their halves (quarters, eighths) which does.
template <int Dim>
struct Outside {
    std::vector<Vec<Dim>> place;
    AlignedVector<double> volume;
};

/// Up to that distance from the shape.
template <int Dim>
Outside<Dim> outsideOf(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                       double reach);

}  // namespace sphinx::fitting
