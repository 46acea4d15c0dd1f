// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/outside.h"

#include "fitting/cells.h"

#include <cmath>

namespace sphinx::fitting {

template <int Dim>
Outside<Dim> outsideOf(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                       double reach) {
    const Cells<Dim> cells{lattice.spacing, lattice.origin};
    const double whole = std::pow(cells.size, Dim);
    constexpr int pieces = 1 << Dim;
    Outside<Dim> outside;
    forEachCell(
        shape, cells, -cells.size, reach,
        [&](const Vec<Dim>& center, double distance) {
            if (partOutside<Dim>(shape, center, distance, cells.size) == 1) {
                outside.place.push_back(center);
                outside.volume.push_back(whole);
                return;
            }
            for (int piece = 0; piece < pieces; ++piece) {
                Vec<Dim> place;
                for (int k = 0; k < Dim; ++k)
                    place[k] = center[k] + (piece >> k & 1 ? 0.25 : -0.25) * cells.size;
                const double part =
                    partOutside<Dim>(shape, place, shape.signedDistance(place), 0.5 * cells.size);
                if (part == 0) continue;
                outside.place.push_back(place);
                outside.volume.push_back(part / pieces * whole);
            }
        },
        [](std::size_t) {});
    return outside;
}

template Outside<2> outsideOf(const geometry::Shape<2>&, const particles::Lattice<2>&, double);
template Outside<3> outsideOf(const geometry::Shape<3>&, const particles::Lattice<3>&, double);

}  // namespace sphinx::fitting
