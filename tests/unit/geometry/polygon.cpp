// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

using namespace sphinx;
using namespace sphinx::geometry;

TEST_CASE("a 2D box answers by closed forms") {
    const auto shape = box(0, 0, 5.366, 2);
    CHECK(shape->measure() == Approx(10.732).epsilon(1e-15));
    CHECK(shape->bounds().lower == Vec<2>(0, 0));
    CHECK(shape->bounds().upper == Vec<2>(5.366, 2));
    CHECK_FALSE(shape->empty());
    CHECK(shape->signedDistance({1, 0.25}) == -0.25);
    CHECK(shape->signedDistance({1, -0.25}) == 0.25);
    CHECK(shape->signedDistance({-3, -4}) == 5);
    CHECK(shape->signedDistance({5.366, 1}) == 0);
    CHECK(shape->normal({5, 1}) == Vec<2>(1, 0));
    CHECK(shape->normal({6, 1}) == Vec<2>(1, 0));
    CHECK(shape->normal({2, 0.1}) == Vec<2>(0, -1));
    CHECK(shape->normal({-3, -4}).isApprox(Vec<2>(-0.6, -0.8), 1e-15));
    const double half = std::sqrt(0.5);
    CHECK(shape->normal({0, 0}).isApprox(Vec<2>(-half, -half), 1e-15));
}

TEST_CASE("points on the boundary are inside, their neighbors in doubles are not") {
    const auto shape = box(0.1, 0.2, 0.7, 0.9);
    const double inf = std::numeric_limits<double>::infinity();
    for (const Vec<2>& p :
         {Vec<2>(0.1, 0.3), Vec<2>(0.7, 0.3), Vec<2>(0.3, 0.2), Vec<2>(0.3, 0.9), Vec<2>(0.1, 0.2),
          Vec<2>(0.7, 0.2), Vec<2>(0.7, 0.9), Vec<2>(0.1, 0.9)}) {
        CHECK(shape->contains(p));
        CHECK(shape->signedDistance(p) == 0);
    }
    for (const Vec<2>& p :
         {Vec<2>(std::nextafter(0.1, -inf), 0.3), Vec<2>(std::nextafter(0.7, inf), 0.3),
          Vec<2>(0.3, std::nextafter(0.2, -inf)), Vec<2>(0.3, std::nextafter(0.9, inf)),
          Vec<2>(std::nextafter(0.1, -inf), 0.2), Vec<2>(0.7, std::nextafter(0.9, inf))}) {
        CHECK_FALSE(shape->contains(p));
        CHECK(shape->signedDistance(p) > 0);
    }
}

TEST_CASE("the side of a skew edge is exact") {
    // Points of the line y = x/3 scaled to whole numbers, and their neighbors: products of such
    // coordinates do not fit into doubles.
    const double big = 94906267;  // above 2^26.5
    const auto shape = makePolygon({{0, 0}, {3 * big, big}, {0, big}});
    for (double k = 1; k < 1000; k += 37) {
        const Vec<2> on(3 * (big - k), big - k);
        CHECK(shape->contains(on));
        CHECK(shape->contains({std::nextafter(on.x(), 0), on.y()}));
        CHECK_FALSE(shape->contains({std::nextafter(on.x(), 1e9), on.y()}));
    }
}

TEST_CASE("a ray through corners is counted once") {
    // Every corner lies at the height of the points asked.
    const auto shape = makePolygon(
        {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}, {4, 2}, {3, 1.5}, {2, 2}, {1, 1.5}, {0, 2}});
    CHECK(shape->contains({3.5, 1}));
    CHECK(shape->contains({0.5, 1}));
    CHECK_FALSE(shape->contains({4.5, 1}));
    CHECK_FALSE(shape->contains({4.5, 0}));
    CHECK_FALSE(shape->contains({3, 0}));
    CHECK_FALSE(shape->contains({1, 2}));
    CHECK(shape->contains({2, 2}));
    CHECK(shape->contains({2, 0}));
}

TEST_CASE("either orientation makes the same polygon") {
    std::vector<Vec<2>> points{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    const auto forward = makePolygon(points);
    std::reverse(points.begin(), points.end());
    const auto backward = makePolygon(points);
    CHECK(forward->measure() == 4);
    CHECK(backward->measure() == 4);
    CHECK(forward->signedDistance({0.5, 0.25}) == backward->signedDistance({0.5, 0.25}));
    CHECK(backward->normal({1.5, 1.1}) == Vec<2>(0, 1));
}

TEST_CASE("the normal at a reflex corner points away from it") {
    const auto shape = makePolygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    // Inside, nearest to the corner (1, 1): outwards is towards it.
    const double half = std::sqrt(0.5);
    CHECK(shape->signedDistance({0.9, 0.9}) == Approx(-std::sqrt(0.02)).epsilon(1e-14));
    CHECK(shape->normal({0.9, 0.9}).isApprox(Vec<2>(half, half), 1e-14));
    CHECK(shape->normal({1, 1}).isApprox(Vec<2>(half, half), 1e-14));
}

TEST_CASE("a circle is exact, and in a boolean right to 1e-6") {
    const Vec<2> center(0.3, -0.2);
    const auto circle = makeBall<2>(center, 0.5);
    CHECK(circle->measure() == Approx(std::numbers::pi / 4).epsilon(1e-15));
    CHECK(circle->signedDistance(center) == -0.5);
    CHECK(circle->signedDistance(center + Vec<2>(3, 4)) == Approx(4.5).epsilon(1e-15));
    CHECK(circle->normal(center + Vec<2>(3, 4)).isApprox(Vec<2>(0.6, 0.8), 1e-15));
    CHECK(circle->bounds().lower.isApprox(Vec<2>(-0.2, -0.7), 1e-15));

    const auto polygon = makeIntersection<2>({circle, box(-2, -2, 2, 2)});
    CHECK(polygon->measure() == Approx(std::numbers::pi / 4).epsilon(1e-12));
    Random random(1);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        const double angle = random.between(0, 6.3);
        const Vec<2> direction(std::cos(angle), std::sin(angle));
        largest = std::max(largest, std::abs(polygon->signedDistance(center + 0.5 * direction)));
        CHECK((polygon->normal(center + 0.6 * direction) - direction).norm() < 2e-3);
    }
    CHECK(largest < 0.5e-6);
    CHECK(largest > 0.3e-6);  // 7.8e-7 of the radius, as documented
}

TEST_CASE("distances to a polygon with many edges agree with the sum of all edges") {
    Random random(7);
    const std::vector<Vec<2>> points = randomStar(random, 3000);
    const auto shape = makePolygon(points);
    for (int i = 0; i < 300; ++i) {
        const Vec<2> p(random.between(-1.2, 1.2), random.between(-1.2, 1.2));
        double nearest = 1e9, winding = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec<2>&a = points[k], &b = points[(k + 1) % points.size()];
            const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (p - a - t * (b - a)).norm());
            const Vec<2> u = a - p, v = b - p;
            winding += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
        }
        const bool inside = std::abs(winding) > 3;
        CHECK(shape->contains(p) == inside);
        CHECK(shape->signedDistance(p) == Approx(inside ? -nearest : nearest).margin(1e-14));
        // The normal is the gradient: a small step along it adds its length.
        const double h = 1e-7;
        const double gain =
            shape->signedDistance(p + h * shape->normal(p)) - shape->signedDistance(p);
        if (nearest > 1e-5) CHECK(gain == Approx(h).epsilon(1e-3));
    }
}
