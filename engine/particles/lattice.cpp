// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/lattice.h"

#include <cmath>

namespace sphinx::particles {
namespace {

/// Of a spacing: points nearer than that to a surface lie on it.
constexpr double on_surface = 1e-6;

/// A small step that leaves no ordinary surface along itself: its components have no simple ratio.
template <int Dim>
Vec<Dim> aside(double spacing) {
    constexpr std::array<double, 3> ratios{1, 0.7320508075688772, 0.4142135623730951};
    Vec<Dim> step;
    for (int k = 0; k < Dim; ++k) step[k] = on_surface * spacing * ratios[k];
    return step;
}

/// for the rows of a lattice
/// about a shape.
template <int Dim, class Use>
void forEachRow(const geometry::Shape<Dim>& shape, const Lattice<Dim>& lattice, Use use) {
    const Box<Dim> bounds = shape.bounds();
    LatticeIndex<Dim> first{};
    LatticeIndex<Dim> last{};
    for (int k = 0; k < Dim; ++k) {
        // One more on either side: contains() decides, not the rounding of the bounds.
        const double begin = (bounds.lower[k] - lattice.origin[k]) / lattice.spacing;
        const double end = (bounds.upper[k] - lattice.origin[k]) / lattice.spacing;
        first[k] = static_cast<long>(std::floor(begin)) - 1;
        last[k] = static_cast<long>(std::ceil(end)) + 1;
    }
    LatticeIndex<Dim> index = first;
    const auto row = static_cast<std::size_t>(last[0] - first[0]);
    const long planes = Dim == 3 ? last[Dim - 1] - first[Dim - 1] : 1;
    for (long z = 0; z < planes; ++z)
        for (index[1] = first[1]; index[1] < last[1]; ++index[1]) {
            if constexpr (Dim == 3) index[2] = first[2] + z;
            use(index, row);
        }
}

template <int Dim>
Vec<Dim> pointOf(const Lattice<Dim>& lattice, const LatticeIndex<Dim>& index) {
    Vec<Dim> p;
    for (int k = 0; k < Dim; ++k)
        p[k] = lattice.origin[k] + (static_cast<double>(index[k]) + 0.5) * lattice.spacing;
    return p;
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> latticePoints(const geometry::Shape<Dim>& shape,
                                    const Lattice<Dim>& lattice) {
    std::vector<Vec<Dim>> points;
    if (shape.empty()) return points;
    const Vec<Dim> step = aside<Dim>(lattice.spacing);
    std::vector<std::uint8_t> inside;
    forEachRow(shape, lattice, [&](LatticeIndex<Dim> index, std::size_t count) {
        inside.resize(count);
        shape.rowContains(pointOf<Dim>(lattice, index) + step, lattice.spacing, count,
                          inside.data());
        for (std::size_t n = 0; n < count; ++n, ++index[0])
            // Rounded like the other coordinates: a mirrored lattice has mirrored points.
            if (inside[n]) points.push_back(pointOf<Dim>(lattice, index));
    });
    return points;
}

template <int Dim>
LatticeScan<Dim> scanLattice(const geometry::Shape<Dim>& shape, const Lattice<Dim>& lattice) {
    LatticeScan<Dim> scan;
    if (shape.empty()) return scan;
    SurfacePoints<Dim>& found = scan.surface;
    const Vec<Dim> step = aside<Dim>(lattice.spacing);
    std::vector<std::uint8_t> above, below;
    forEachRow(shape, lattice, [&](LatticeIndex<Dim> index, std::size_t count) {
        above.resize(count);
        below.resize(count);
        const Vec<Dim> first = pointOf<Dim>(lattice, index);
        shape.rowContains(first + step, lattice.spacing, count, above.data());
        shape.rowContains(first - step, lattice.spacing, count, below.data());
        for (std::size_t n = 0; n < count; ++n, ++index[0]) {
            if (!above[n] && !below[n]) continue;
            const Vec<Dim> point = pointOf<Dim>(lattice, index);
            if (above[n]) scan.points.push_back(point);
            if (above[n] == below[n]) continue;
            ++found.count;
            const Vec<Dim> normal = shape.normal(point);
            for (int k = 0; k < Dim; ++k)
                if (std::abs(normal[k]) > 1 - on_surface)
                    (normal[k] < 0 ? found.lower : found.upper)[k].push_back(index);
        }
    });
    return scan;
}

template <int Dim>
SurfacePoints<Dim> surfacePoints(const geometry::Shape<Dim>& shape, const Lattice<Dim>& lattice) {
    return scanLattice(shape, lattice).surface;
}

template std::vector<Vec<2>> latticePoints(const geometry::Shape<2>&, const Lattice<2>&);
template std::vector<Vec<3>> latticePoints(const geometry::Shape<3>&, const Lattice<3>&);
template LatticeScan<2> scanLattice(const geometry::Shape<2>&, const Lattice<2>&);
template LatticeScan<3> scanLattice(const geometry::Shape<3>&, const Lattice<3>&);
template SurfacePoints<2> surfacePoints(const geometry::Shape<2>&, const Lattice<2>&);
template SurfacePoints<3> surfacePoints(const geometry::Shape<3>&, const Lattice<3>&);

}  // namespace sphinx::particles
