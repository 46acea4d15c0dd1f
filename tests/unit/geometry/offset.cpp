// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <catch2/catch.hpp>
#include <numbers>

using namespace sphinx;
using namespace sphinx::geometry;

namespace {

const std::vector<Vec<2>> l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

}  // namespace

TEST_CASE("the offset of a box is the box of its displaced corners, bit by bit") {
    const auto grown = makeOffset<2>(box(0, 0, 5.366, 5.366), 0.1);
    CHECK(grown->bounds().lower == Vec<2>(-0.1, -0.1));
    CHECK(grown->bounds().upper == Vec<2>(5.366 + 0.1, 5.366 + 0.1));
    CHECK(grown->measure() == box(-0.1, -0.1, 5.366 + 0.1, 5.366 + 0.1)->measure());
    CHECK(grown->contains({-0.1, -0.1}));
    const auto shrunk = makeOffset<2>(box(0.1, 0.2, 0.7, 0.9), -0.05);
    CHECK(shrunk->bounds().lower == Vec<2>(0.1 + 0.05, 0.2 + 0.05));
    CHECK(shrunk->bounds().upper == Vec<2>(0.7 - 0.05, 0.9 - 0.05));
    CHECK(makeOffset<2>(shrunk, 0)->measure() == shrunk->measure());
}

TEST_CASE("the offset of an L moves every edge") {
    const auto shape = makePolygon(l_shape);
    // Area a + perimeter d + (convex - reflex corners) d^2 = 4 + 10 d + 4 d^2 with right angles.
    for (const double d : {0.25, -0.25, 0.5, 2.0}) {
        CHECK(makeOffset<2>(shape, d)->measure() == Approx(4 + 10 * d + 4 * d * d).epsilon(1e-14));
    }
    const auto grown = makeOffset<2>(shape, 0.25);
    CHECK(grown->contains({-0.25, 3.25}));
    CHECK(grown->contains({1.25, 1.25}));
    CHECK_FALSE(grown->contains({1.26, 1.26}));
    CHECK(makeOffset<2>(shape, -0.25)->contains({0.75, 0.75}));
    CHECK_FALSE(makeOffset<2>(shape, -0.25)->contains({0.8, 0.8}));
}

TEST_CASE("holes shrink when the shape grows, and close") {
    const auto shape = makeDifference<2>({box(0, 0, 4, 4), box(1, 1, 3, 2)});
    CHECK(makeOffset<2>(shape, 0.25)->measure() == 4.5 * 4.5 - 1.5 * 0.5);
    CHECK(makeOffset<2>(shape, -0.25)->measure() == 3.5 * 3.5 - 2.5 * 1.5);
    CHECK(makeOffset<2>(shape, 0.5)->measure() == 25);
    CHECK(makeOffset<2>(shape, 0.75)->measure() == 5.5 * 5.5);
    // Square: displaced by more than half its width, its corners would come out again as a square.
    const auto square = makeDifference<2>({box(0, 0, 4, 4), box(1, 1, 2, 2)});
    CHECK(makeOffset<2>(square, 0.75)->measure() == 5.5 * 5.5);
    const auto round = makeDifference<2>({box(0, 0, 4, 4), makeBall<2>({2, 2}, 0.5)});
    CHECK(makeOffset<2>(round, 0.75)->measure() == 5.5 * 5.5);
    CHECK(makeOffset<2>(round, 0.25)->measure() ==
          Approx(4.5 * 4.5 - std::numbers::pi / 16).epsilon(1e-6));
}

TEST_CASE("an offset splits at a neck and fills a slot") {
    const auto dumbbell = makeUnion<2>({box(0, 0, 2, 2), box(3, 0, 5, 2), box(2, 0.75, 3, 1.25)});
    const auto split = makeOffset<2>(dumbbell, -0.5);
    CHECK(split->measure() == 2);
    CHECK_FALSE(split->contains({2.5, 1}));
    // The slot is 1 wide and 2 deep; 0.5 from either side closes it.
    const auto slotted =
        makePolygon({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
    CHECK(makeOffset<2>(slotted, 0.6)->measure() == Approx(4.2 * 4.2).epsilon(1e-14));
    CHECK(makeOffset<2>(slotted, 0.25)->measure() == Approx(3.5 * 3.5 - 0.5 * 2).epsilon(1e-14));
    // Two islands grow together.
    const auto pair = makeUnion<2>({box(0, 0, 1, 1), box(2, 0, 3, 1)});
    CHECK(makeOffset<2>(pair, 0.75)->measure() == 4.5 * 2.5);
}

TEST_CASE("a part that vanishes leaves the others") {
    const auto pair = makeUnion<2>({box(0, 0, 1, 1), box(2, 0, 6, 4)});
    CHECK(makeOffset<2>(pair, -0.75)->measure() == 2.5 * 2.5);
    // The hole goes with the island around it.
    const auto hollow = makeUnion<2>(
        {makeDifference<2>({box(0, 0, 1, 1), box(0.4, 0.4, 0.6, 0.6)}), box(2, 0, 6, 4)});
    CHECK(makeOffset<2>(hollow, -0.75)->measure() == 2.5 * 2.5);
}

TEST_CASE("random shapes: an offset keeps its distance") {
    Random random(5);
    for (int trial = 0; trial < 8; ++trial) {
        const auto shape = makePolygon(randomStar(random, 30 + 10 * trial));
        const double d = 0.03 + 0.01 * trial;
        const auto grown = makeOffset<2>(shape, d), shrunk = makeOffset<2>(shape, -d);
        for (int i = 0; i < 500; ++i) {
            const Vec<2> p(random.between(-1.2, 1.2), random.between(-1.2, 1.2));
            const double distance = shape->signedDistance(p);
            // A mitre may add points that are further away, never take nearer ones.
            if (distance < d - 1e-9) CHECK(grown->contains(p));
            if (distance > 10.1 * d) CHECK_FALSE(grown->contains(p));
            if (distance > -d + 1e-9) CHECK_FALSE(shrunk->contains(p));
            if (distance < -10.1 * d) CHECK(shrunk->contains(p));
        }
    }
}

TEST_CASE("random shapes: an offset adds or takes what the edges sweep over") {
    // The definition, edge by edge: a rectangle for each, and where two part, the gap up to where
    // their lines meet. Small offsets turn no edge around, larger ones do.
    Random random(9);
    for (const double d : {0.002, 0.01, 0.03, 0.1, -0.002, -0.01, -0.03, -0.08}) {
        const std::vector<Vec<2>> points = randomStar(random, 16);
        std::vector<ShapePointer<2>> swept{makePolygon(points)};
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec<2>&a = points[i], &b = points[(i + 1) % 16], &c = points[(i + 2) % 16];
            const Vec<2> ab = (b - a).normalized(), bc = (c - b).normalized();
            const Vec<2> n(ab.y(), -ab.x()), m(bc.y(), -bc.x());
            swept.push_back(makePolygon({a, b, b + d * n, a + d * n}));
            const double sine = ab.x() * bc.y() - ab.y() * bc.x(), cosine = ab.dot(bc);
            if (sine * d <= 0) continue;
            REQUIRE(cosine > -0.98);  // no mitre is cut
            const Vec<2> tip = b + d * n + std::abs(d) * (1 - cosine) / std::abs(sine) * ab;
            swept.push_back(makePolygon({b, b + d * n, tip, b + d * m}));
        }
        const auto expected = d > 0 ? makeUnion<2>(swept) : makeDifference<2>(swept);
        const auto offset = makeOffset<2>(swept.front(), d);
        CHECK(offset->measure() == Approx(expected->measure()).epsilon(1e-12));
        CHECK(makeDifference<2>({offset, expected})->measure() < 1e-12);
    }
}

TEST_CASE("convex polygons: area by Steiner's formula with mitres") {
    // Regular polygons: the offset scales the inradius.
    for (const int n : {3, 5, 17}) {
        std::vector<Vec<2>> points;
        for (int k = 0; k < n; ++k) {
            const double angle = 2 * std::numbers::pi * k / n;
            points.emplace_back(std::cos(angle), std::sin(angle));
        }
        const auto shape = makePolygon(points);
        const double inradius = std::cos(std::numbers::pi / n);
        for (const double d : {0.7, -0.3, -0.49}) {
            const double scale = (inradius + d) / inradius;
            CHECK(makeOffset<2>(shape, d)->measure() ==
                  Approx(scale * scale * shape->measure()).epsilon(1e-12));
        }
    }
    // One edge vanishes on the way: a box without a small corner.
    const auto cut = makePolygon({{0, 0}, {4, 0}, {4, 3.5}, {3.5, 4}, {0, 4}});
    CHECK(makeOffset<2>(cut, -1)->measure() == Approx(4).epsilon(1e-14));
}

TEST_CASE("a needle's mitre is cut at ten offsets") {
    const auto needle = makePolygon({{0, 0}, {10, 0.1}, {0, 0.2}});
    const auto grown = makeOffset<2>(needle, 0.1);
    CHECK(grown->bounds().upper.x() == Approx(11).epsilon(1e-12));
    CHECK(grown->contains({10.99, 0.1}));
    CHECK(grown->contains({5, 0.1}));
    CHECK_FALSE(grown->contains({10.99, 0.25}));
}

TEST_CASE("circles stay circles") {
    CHECK(makeOffset<2>(makeBall<2>({0, 0}, 0.5), 0.25)->signedDistance({1, 0}) == 0.25);
    CHECK(makeOffset<2>(makeBall<2>({0, 0}, 0.5), -0.25)->measure() ==
          Approx(std::numbers::pi / 16).epsilon(1e-15));
}

TEST_CASE("an offset that leaves nothing is an error") {
    CHECK(messageOf([] { makeOffset<2>(box(0, 0, 2, 1), -0.5); }) ==
          "offset -0.5 leaves nothing of a shape of size 2 x 1");
    CHECK(messageOf([] { makeOffset<2>(box(0, 0, 1, 1), -0.6); }) ==
          "offset -0.6 leaves nothing of a shape of size 1 x 1");
    CHECK(messageOf([] { makeOffset<2>(makePolygon(l_shape), -0.5); }) ==
          "offset -0.5 leaves nothing of a shape of size 2 x 3");
    CHECK(messageOf([] {
              makeOffset<2>(makeBall<2>({0, 0}, 1), -1);
          }) == "offset -1 leaves nothing of a shape of size 2 x 2");
    CHECK(messageOf([] { makeOffset<2>(box(0, 0, 1, 1), nan_value); }) ==
          "offset nan must be finite");
    CHECK(messageOf([] {
              const auto one = box(0, 0, 1, 1);
              makeOffset<2>(makeDifference<2>({one, one}), 1);
          }) == "an empty shape cannot be offset");
}
