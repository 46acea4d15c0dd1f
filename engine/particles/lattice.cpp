// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/lattice.h"

#include <cmath>

namespace sphinx::particles {

template <int Dim>
std::vector<Vec<Dim>> latticePoints(const geometry::Shape<Dim>& shape, double spacing,
                                    const Vec<Dim>& origin) {
    std::vector<Vec<Dim>> points;
    if (shape.empty()) return points;
    const Box<Dim> bounds = shape.bounds();
    std::array<long, Dim> first{};
    std::array<long, Dim> count{};
    for (int k = 0; k < Dim; ++k) {
        // One more on either side: contains() decides, not the rounding of the bounds.
        first[k] = static_cast<long>(std::floor((bounds.lower[k] - origin[k]) / spacing)) - 1;
        count[k] =
            static_cast<long>(std::ceil((bounds.upper[k] - origin[k]) / spacing)) + 1 - first[k];
    }
    const auto coordinate = [&](int k, long n) {
        return origin[k] + (static_cast<double>(first[k] + n) + 0.5) * spacing;
    };
    const auto row = static_cast<std::size_t>(count[0]);
    std::vector<std::uint8_t> inside(row);
    const long planes = Dim == 3 ? count[Dim - 1] : 1;
    for (long z = 0; z < planes; ++z)
        for (long y = 0; y < count[1]; ++y) {
            Vec<Dim> p;
            p[0] = coordinate(0, 0);
            p[1] = coordinate(1, y);
            if constexpr (Dim == 3) p[2] = coordinate(2, z);
            shape.rowContains(p, spacing, row, inside.data());
            for (std::size_t x = 0; x < row; ++x) {
                if (!inside[x]) continue;
                // Rounded like the other coordinates: a mirrored lattice has mirrored points.
                p[0] = coordinate(0, static_cast<long>(x));
                points.push_back(p);
            }
        }
    return points;
}

template std::vector<Vec<2>> latticePoints(const geometry::Shape<2>&, double, const Vec<2>&);
template std::vector<Vec<3>> latticePoints(const geometry::Shape<3>&, double, const Vec<3>&);

}  // namespace sphinx::particles
