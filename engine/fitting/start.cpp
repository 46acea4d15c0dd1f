// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/start.h"

#include "fitting/cells.h"
#include "fitting/measure.h"
#include "fitting/row_members.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace sphinx::fitting {
namespace {

/// Depths and distances that are compared, in spacings.
constexpr double rounding = 1e-6;
constexpr double tolerated = 0.005;

template <int Dim>
struct Point {
    std::int64_t distance;  ///< from the surface, in units of the rounding
    std::int64_t aside;     ///< sum of the coordinates' distances from the middle, likewise
    std::uint64_t place;    ///< in the order of the lattice
    Vec<Dim> x;
};

/// The end of the run of points that `same` does not tell apart, and of which `wanted` is one,
/// or its begin, whichever is nearer.
template <class Points, class Same>
std::size_t nearestEdge(const Points& points, std::size_t wanted, Same&& same) {
    std::size_t low = wanted, high = wanted;
    while (low > 0 && same(points[low - 1], points[low])) --low;
    while (high > 0 && high < points.size() && same(points[high - 1], points[high])) ++high;
    return wanted - low < high - wanted ? low : high;
}

/// How many of the points, that many about, are deeper than the others.
template <class Points>
std::size_t deepest(const Points& points, double number) {
    const auto wanted = std::min(static_cast<std::size_t>(std::llround(number)), points.size());
    const auto best = [&](std::size_t count) {
        return std::abs(static_cast<double>(count) - number) <= tolerated * number;
    };
    const std::size_t by_depth = nearestEdge(
        points, wanted, [](const auto& a, const auto& b) { return a.distance == b.distance; });
    if (best(by_depth)) return by_depth;
    const std::size_t by_place = nearestEdge(points, wanted, [](const auto& a, const auto& b) {
        return a.distance == b.distance && a.aside == b.aside;
    });
    return best(by_place) ? by_place : wanted;
}

}  // namespace

template <int Dim>
Start<Dim> startOf(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice) {
    Start<Dim> start;
    if (shape.empty()) return start;
    const double unit = rounding * lattice.spacing;
    const Box<Dim> bounds = shape.bounds();
    const Vec<Dim> middle = 0.5 * (bounds.lower + bounds.upper);
    std::vector<Point<Dim>> points;
    forEachCell(
        shape, Cells<Dim>{lattice.spacing, lattice.origin},
        -std::numeric_limits<double>::infinity(), lattice.spacing,
        [&](const Vec<Dim>& x, double distance) {
            points.push_back({std::llround(distance / unit),
                              std::llround((x - middle).template lpNorm<1>() / unit), points.size(),
                              x});
        },
        [](std::size_t) {});
    // From the deepest on.
    std::ranges::sort(points, {},
                      [](const Point<Dim>& p) { return std::tuple(p.distance, p.aside, p.place); });
    const double whole = measure(shape, lattice);
    const double exact = whole / std::pow(lattice.spacing, Dim);
    points.resize(deepest(points, exact));
    if (points.empty()) return start;
    start.volume = whole / static_cast<double>(points.size());
    std::ranges::sort(points, {}, &Point<Dim>::place);
    for (const Point<Dim>& point : points) start.points.push_back(point.x);
    start.in_row = rowMembers(shape, lattice, start.points, start.volume);
    return start;
}

template Start<2> startOf(const geometry::Shape<2>&, const particles::Lattice<2>&);
template Start<3> startOf(const geometry::Shape<3>&, const particles::Lattice<3>&);

}  // namespace sphinx::fitting
