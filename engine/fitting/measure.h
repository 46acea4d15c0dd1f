// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fitting/cells.h"
#include "geometry/shape.h"
#include "particles/lattice.h"

namespace sphinx::fitting {

/// Area or volume of a shape: where it has no closed form, that of cells of half a spacing.
template <int Dim>
double measure(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice);

/// The same of the layer at its surface, so deep.
template <int Dim>
double measureLayer(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                    double depth);

/// Calls use(center, volume) for the cells of half a spacing with that part of their volume which
/// lies in the layer. The volumes are multiples of a power of two of a cell's, so that their sum
/// does not depend on the order.
template <int Dim, class Use>
void forEachPieceOfLayer(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                         double depth, Use&& use) {
    const Cells<Dim> cells{0.5 * lattice.spacing, lattice.origin};
    const double volume = std::pow(cells.size, Dim);
    forEachCell(
        shape, cells, -depth - cells.size, cells.size,
        [&](const Vec<Dim>& center, double distance) {
            const double part = partOutside<Dim>(shape, center, distance + depth, cells.size) -
                                partOutside<Dim>(shape, center, distance, cells.size);
            if (part > 0) use(center, std::round(part * 0x1p20) * 0x1p-20 * volume);
        },
        [](std::size_t) {});
}

}  // namespace sphinx::fitting
