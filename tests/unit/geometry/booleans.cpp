// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <catch2/catch.hpp>
#include <numbers>

using namespace sphinx;
using namespace sphinx::geometry;

TEST_CASE("booleans of boxes are exact") {
    const auto a = box(0, 0, 2, 2), b = box(1, 1, 3, 3);
    CHECK(makeUnion<2>({a, b})->measure() == 7);
    CHECK(makeIntersection<2>({a, b})->measure() == 1);
    CHECK(makeDifference<2>({a, b})->measure() == 3);
    CHECK(makeIntersection<2>({a, b})->bounds().lower == Vec<2>(1, 1));
    CHECK(makeIntersection<2>({a, b})->bounds().upper == Vec<2>(2, 2));
    // Several at once.
    CHECK(makeUnion<2>({a, b, box(2, 0, 3, 1), box(0, 0, 1, 1)})->measure() == 8);
    CHECK(makeDifference<2>({a, box(0, 0, 1, 1), box(1, 1, 2, 2)})->measure() == 2);
    CHECK(makeIntersection<2>({a, b, box(1.5, 0, 3, 3)})->measure() == 0.5);
}

TEST_CASE("a wall around a box has a hole") {
    const auto inside = box(0, 0, 5.366, 5.366);
    const auto wall = makeDifference<2>({makeOffset<2>(inside, 0.1), inside});
    CHECK(wall->measure() == Approx(5.566 * 5.566 - 5.366 * 5.366).epsilon(1e-13));
    CHECK(wall->contains({-0.05, 2}));
    CHECK(wall->contains({-0.05, -0.05}));
    CHECK_FALSE(wall->contains({1, 1}));
    CHECK(wall->contains({0, 1}));  // closed: the surface of what was taken away stays
    CHECK(wall->signedDistance({2, 0.5}) == 0.5);
    CHECK(wall->signedDistance({2, -0.025}) == -0.025);
    CHECK(wall->normal({2, -0.025}) == Vec<2>(0, 1));
    CHECK(wall->normal({2, -0.075}) == Vec<2>(0, -1));
}

TEST_CASE("shared edges disappear in a union and leave nothing in a difference") {
    const auto left = box(0, 0, 0.1, 1), right = box(0.1, 0, 0.3, 1);
    const auto both = makeUnion<2>({left, right});
    CHECK(both->signedDistance({0.1, 0.5}) == -0.1);  // not zero: no edge at x = 0.1
    CHECK(both->measure() == Approx(0.3).epsilon(1e-15));
    const auto rest = makeDifference<2>({both, right});
    CHECK(rest->bounds().upper == Vec<2>(0.1, 1));
    CHECK(rest->measure() == left->measure());
}

TEST_CASE("nothing left is an empty shape with definite answers") {
    const auto none = makeIntersection<2>({box(0, 0, 1, 1), box(2, 2, 3, 3)});
    CHECK(none->empty());
    CHECK(none->measure() == 0);
    CHECK_FALSE(none->contains({0.5, 0.5}));
    CHECK(none->signedDistance({0.5, 0.5}) == std::numeric_limits<double>::infinity());
    CHECK(none->normal({0.5, 0.5}) == Vec<2>(0, 0));
    CHECK(none->bounds().empty());
    std::uint8_t row[2] = {7, 7};
    none->rowContains({0, 0}, 1, 2, row);
    CHECK(row[0] == 0);
    CHECK(row[1] == 0);
    CHECK(makeDifference<2>({box(0, 0, 1, 1), box(0, 0, 1, 1)})->empty());
    CHECK(makeIntersection<2>({box(0, 0, 1, 1), box(1, 0, 2, 1)})->empty());  // only an edge
    CHECK(makeUnion<2>({none, box(0, 0, 1, 1)})->measure() == 1);
    CHECK(makeDifference<2>({box(0, 0, 1, 1), none})->measure() == 1);
}

TEST_CASE("islands in holes, and shapes that touch in a corner") {
    const auto ring = makeDifference<2>({box(0, 0, 10, 10), box(1, 1, 9, 9)});
    const auto island = makeUnion<2>({ring, box(4, 4, 6, 6)});
    CHECK(island->measure() == 36 + 4);
    CHECK(island->contains({5, 5}));
    CHECK_FALSE(island->contains({2, 2}));
    CHECK(makeUnion<2>({island, box(2, 2, 3, 3)})->measure() == 41);
    CHECK(makeDifference<2>({box(0, 0, 10, 10), island})->measure() == 60);

    const auto corner = makeUnion<2>({box(0, 0, 1, 1), box(1, 1, 2, 2)});
    CHECK(corner->measure() == 2);
    CHECK(corner->contains({1, 1}));
    CHECK_FALSE(corner->contains({1.5, 0.5}));
    CHECK(makeUnion<2>({corner, box(1, 0, 2, 1)})->measure() == 3);
    CHECK(makeDifference<2>({box(0, 0, 3, 3), corner, box(2, 0, 3, 1)})->measure() == 6);
}

TEST_CASE("areas of random shapes obey inclusion and exclusion") {
    Random random(11);
    for (int trial = 0; trial < 10; ++trial) {
        const auto a = makePolygon(randomStar(random, 40));
        const auto b = makeTranslated<2>(makePolygon(randomStar(random, 60)), {0.3, 0.1});
        const auto c = makeBall<2>({-0.2, 0.2}, 0.5);
        const auto both = makeIntersection<2>({a, b});
        CHECK(makeUnion<2>({a, b})->measure() ==
              Approx(a->measure() + b->measure() - both->measure()).epsilon(1e-12));
        CHECK(makeDifference<2>({a, b})->measure() ==
              Approx(a->measure() - both->measure()).epsilon(1e-12));
        // Results go into further booleans, rounded corners and all; shared boundaries many times.
        const auto ab = makeUnion<2>({a, b}), bc = makeUnion<2>({b, c});
        CHECK(makeUnion<2>({ab, bc, both, makeDifference<2>({a, b})})->measure() ==
              Approx(makeUnion<2>({a, b, c})->measure()).epsilon(1e-12));
        CHECK(makeDifference<2>({ab, bc})->measure() ==
              Approx(makeDifference<2>({a, b, c})->measure()).epsilon(1e-12));
        for (int i = 0; i < 200; ++i) {
            const Vec<2> p(random.between(-1, 1), random.between(-1, 1));
            CHECK(ab->contains(p) == (a->contains(p) || b->contains(p)));
            CHECK(both->contains(p) == (a->contains(p) && b->contains(p)));
        }
    }
}

TEST_CASE("many overlapping collinear edges are each counted once") {
    // A staircase of boxes that share parts of two lines, in every pairing.
    std::vector<ShapePointer<2>> boxes;
    for (int i = 0; i < 6; ++i) {
        for (int j = i + 1; j <= 6; ++j) boxes.push_back(box(i, 0, j, 1));
    }
    CHECK(makeUnion<2>(boxes)->measure() == 6);
    CHECK(makeUnion<2>(boxes)->signedDistance({3, 0.5}) == -0.5);
    std::vector<ShapePointer<2>> lower{box(0, 0, 6, 2)};
    lower.insert(lower.end(), boxes.begin(), boxes.end());
    CHECK(makeDifference<2>(lower)->measure() == 6);
    CHECK(makeDifference<2>(lower)->bounds().lower == Vec<2>(0, 1));
}

TEST_CASE("a circular hole in a box") {
    const auto pool = makeDifference<2>({box(0, 0, 2, 1), makeBall<2>({1, 0.5}, 0.25)});
    CHECK(pool->measure() == Approx(2 - std::numbers::pi / 16).epsilon(1e-12));
    CHECK(pool->signedDistance({1, 0.5}) == Approx(0.25).epsilon(1e-6));
    CHECK(pool->normal({1.3, 0.5}).isApprox(Vec<2>(-1, 0), 2e-3));
    CHECK(makeUnion<2>({pool, makeBall<2>({1, 0.5}, 0.25)})->measure() == Approx(2).epsilon(1e-15));
}
