// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "kernels/kernel.h"
#include "neighbors/cell_grid.h"
#include "neighbors/neighbor_list.h"

namespace sphinx::neighbors {

/// Fills `list` with the neighbors in `to` of the particles in `from` within the kernel's cutoff,
/// over the periodic images of the domain. With same = true a particle does not see itself.
/// The order of neighbors depends on the two grids only, not on threads.
template <int Dim, class Real>
void buildList(const CellGrid<Dim>& from, const CellGrid<Dim>& to, bool same,
               const kernels::Kernel<Dim>& kernel, const bodies::Domain<Dim>& domain,
               NeighborList<Dim, Real>& list);

}  // namespace sphinx::neighbors
