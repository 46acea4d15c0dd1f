// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/lattice.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::particles;

namespace {

Vec<2> at(double x, double y) { return {x, y}; }

std::size_t count(const geometry::ShapePointer<2>& shape) {
    return latticePoints<2>(*shape, {0.1, Vec<2>::Zero()}).size();
}

}  // namespace

TEST_CASE("a lattice fills boxes between its lines, and of those through its points one side") {
    CHECK(count(geometry::makeBox<2>(at(0, 0), at(1, 0.5))) == 50);
    CHECK(count(geometry::makeBox<2>(at(0.05, 0.05), at(1.05, 0.55))) == 50);
    CHECK(count(geometry::makeBox<2>(at(-0.55, -0.55), at(-0.05, 0.45))) == 50);
    const auto points =
        latticePoints<2>(*geometry::makeBox<2>(at(0.05, 0), at(0.25, 0.1)), {0.1, Vec<2>::Zero()});
    REQUIRE(points.size() == 2);
    CHECK(points[0] == at(0.05, 0.05));
    CHECK(points[1].x() == Approx(0.15));
}

TEST_CASE("a point on the surface of two shapes belongs to one of them") {
    // Both halves of a square along its diagonals, which run through points.
    for (const bool rising : {true, false}) {
        const Vec<2> a = rising ? at(0, 0) : at(1, 0);
        const Vec<2> b = rising ? at(1, 1) : at(0, 1);
        const Vec<2> c = rising ? at(1, 0) : at(0, 0);
        const Vec<2> d = rising ? at(0, 1) : at(1, 1);
        const std::size_t one = count(geometry::makePolygon({a, b, c}));
        const std::size_t other = count(geometry::makePolygon({a, b, d}));
        INFO(one << " and " << other);
        CHECK(one + other == 100);
    }
    const Vec<3> half(0.35, 0.35, 0.35);
    const Lattice<3> lattice{0.1, Vec<3>::Zero()};
    std::size_t sum = 0;
    for (int octant = 0; octant < 8; ++octant) {
        const Vec<3> corner(octant & 1 ? 1 : -0.3, octant & 2 ? 1 : -0.3, octant & 4 ? 1 : -0.3);
        const auto box = geometry::makeBox<3>(half.cwiseMin(corner), half.cwiseMax(corner));
        sum += latticePoints<3>(*box, lattice).size();
    }
    CHECK(sum == 13 * 13 * 13);
}

TEST_CASE("points on faces are found by axis and side") {
    const auto box = geometry::makeBox<2>(at(0.05, 0), at(0.45, 0.3));
    const auto found = surfacePoints<2>(*box, {0.1, Vec<2>::Zero()});
    CHECK(found.count == 6);
    CHECK(found.lower[0].size() == 3);
    CHECK(found.upper[0].size() == 3);
    CHECK(found.lower[1].empty());
    CHECK(found.upper[1].empty());
    CHECK(surfacePoints<2>(*box, {0.1, at(0.05, 0)}).count == 0);
    // Oblique ones count, and belong to no axis.
    const auto triangle = geometry::makePolygon({at(0, 0), at(1, 0), at(1, 1)});
    const auto oblique = surfacePoints<2>(*triangle, {0.1, Vec<2>::Zero()});
    CHECK(oblique.count == 10);
    CHECK((oblique.lower[0].empty() && oblique.upper[0].empty()));
    CHECK((oblique.lower[1].empty() && oblique.upper[1].empty()));
}
