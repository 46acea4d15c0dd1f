// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/measure.h"

#include <cmath>

namespace sphinx::fitting {

template <int Dim>
double measure(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice) {
    if (std::isfinite(shape.measure())) return shape.measure();
    const Cells<Dim> cells{0.5 * lattice.spacing, lattice.origin};
    // A layer that holds all cells at the surface, and those below it.
    double sum = 0;
    forEachPieceOfLayer(shape, lattice, cells.size,
                        [&](const Vec<Dim>&, double volume) { sum += volume; });
    forEachCell(
        shape, cells, -2 * cells.size, 0.0,
        [&](const Vec<Dim>& center, double distance) {
            const double part =
                1 - partOutside<Dim>(shape, center, distance + cells.size, cells.size);
            sum += std::round(part * 0x1p20) * 0x1p-20 * std::pow(cells.size, Dim);
        },
        [&](std::size_t whole) { sum += static_cast<double>(whole) * std::pow(cells.size, Dim); });
    return sum;
}

template <int Dim>
double measureLayer(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                    double depth) {
    double sum = 0;
    forEachPieceOfLayer(shape, lattice, depth,
                        [&](const Vec<Dim>&, double volume) { sum += volume; });
    return sum;
}

template double measure(const geometry::Shape<2>&, const particles::Lattice<2>&);
template double measure(const geometry::Shape<3>&, const particles::Lattice<3>&);
template double measureLayer(const geometry::Shape<2>&, const particles::Lattice<2>&, double);
template double measureLayer(const geometry::Shape<3>&, const particles::Lattice<3>&, double);

}  // namespace sphinx::fitting
