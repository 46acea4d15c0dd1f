// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <catch2/catch.hpp>
#include <numbers>

using namespace sphinx;
using namespace sphinx::geometry;

namespace {

using Point = Vec<3>;

}  // namespace

TEST_CASE("a 3D box answers by closed forms") {
    const auto shape = makeBox<3>({0.1, 0, 0}, {2, 3, 4});
    CHECK(shape->contains({0.1, 0, 0}));
    CHECK(shape->contains({2, 3, 4}));
    CHECK_FALSE(shape->contains({std::nextafter(0.1, 0), 1, 1}));
    CHECK_FALSE(shape->contains({1, 1, std::nextafter(4, 5)}));
    CHECK(shape->signedDistance({1, 1, 0.5}) == -0.5);
    CHECK(shape->signedDistance({1, 1, 4.5}) == 0.5);
    CHECK(shape->signedDistance({5, 7, 4}) == 5);
    CHECK(shape->signedDistance({4, 5, 5}) == 3);
    CHECK(shape->normal({1, 2.9, 2}) == Point(0, 1, 0));
    CHECK(shape->normal({1, 2, 0}) == Point(0, 0, -1));
    CHECK(shape->normal({5, 7, 4}).isApprox(Point(0.6, 0.8, 0), 1e-15));
    CHECK(shape->bounds().upper == Point(2, 3, 4));
    CHECK(shape->measure() == Approx(shape->bounds().size().prod()));
}

TEST_CASE("moved and turned boxes keep their faces") {
    const auto shape = makeBox<3>({0, 0, 0}, {1, 2, 3});
    const auto moved = makeTranslated<3>(shape, {0.1, 0.2, 0.3});
    CHECK(moved->contains({1.1, 2.2, 3.3}));
    CHECK(moved->contains({0.1, 0.2, 0.3}));
    const auto turned = makeRotated(shape, std::numbers::pi / 2, {0, 0, 0}, {0, 0, 2});
    CHECK(turned->bounds().lower == Point(-2, 0, 0));
    CHECK(turned->bounds().upper == Point(0, 1, 3));
    const auto skew = makeRotated(shape, std::numbers::pi / 4, {0, 0, 0}, {0, 0, 1});
    const double half = std::sqrt(0.5);
    CHECK(skew->bounds().lower.isApprox(Point(-2 * half, 0, 0), 1e-14));
    CHECK(skew->bounds().upper.isApprox(Point(half, 3 * half, 3), 1e-14));
    CHECK(skew->signedDistance({half, -half, 1}) == Approx(1).epsilon(1e-14));
    CHECK(skew->normal({half, -half, 1}).isApprox(Point(half, -half, 0), 1e-14));
}

TEST_CASE("a ball answers by closed forms") {
    const auto shape = makeBall<3>({1, 1, 1}, 2);
    CHECK(shape->measure() == Approx(32 * std::numbers::pi / 3));
    CHECK(shape->signedDistance({1, 1, 1}) == -2);
    CHECK(shape->signedDistance({3, 3, 2}) == 1);
    CHECK(shape->contains({1, 1, 3}));
    CHECK(shape->normal({3, 3, 2}).isApprox(Point(2, 2, 1) / 3, 1e-15));
    CHECK(shape->normal({1, 1, 1}).norm() == 1);
    CHECK(shape->bounds().lower == Point(-1, -1, -1));
}

TEST_CASE("a torus answers by closed forms") {
    const auto shape = makeTorus({0, 0, 1}, {0, 0, 3}, 2, 0.5);
    CHECK(shape->measure() == Approx(std::numbers::pi * std::numbers::pi));
    CHECK(shape->contains({2.5, 0, 1}));
    CHECK(shape->contains({0, -1.5, 1}));
    CHECK_FALSE(shape->contains({0, 0, 1}));
    CHECK(shape->signedDistance({0, 2, 1}) == -0.5);
    CHECK(shape->signedDistance({0, 0, 1}) == 1.5);
    CHECK(shape->signedDistance({5, 0, 5}) == 4.5);
    CHECK(shape->normal({5, 0, 5}).isApprox(Point(0.6, 0, 0.8), 1e-15));
    CHECK(shape->normal({0, 1.75, 1}).isApprox(Point(0, -1, 0), 1e-15));
    CHECK(shape->normal({2, 0, 1}).norm() == 1);
    CHECK(shape->bounds().lower.isApprox(Point(-2.5, -2.5, 0.5), 1e-15));
    CHECK(shape->bounds().upper.isApprox(Point(2.5, 2.5, 1.5), 1e-15));

    const auto turned = makeRotated(shape, std::numbers::pi / 2, {0, 0, 1}, {1, 0, 0});
    CHECK(turned->signedDistance({0, 4, 1}) == Approx(std::sqrt(20.) - 0.5));
    CHECK(turned->signedDistance({0, 0, 3.75}) == Approx(0.25));
    CHECK(turned->bounds().upper.isApprox(Point(2.5, 0.5, 3.5), 1e-12));
    const auto grown = makeOffset<3>(shape, 0.25);
    CHECK(grown->signedDistance({2.5, 0, 1}) == Approx(-0.25));
    CHECK(makeScaled<3>(shape, 2, {0, 0, 1})->measure() == Approx(8 * shape->measure()));
    CHECK_THROWS_AS(makeTorus({0, 0, 0}, {0, 0, 1}, 1, 1), ShapeError);
    CHECK_THROWS_AS(makeTorus({0, 0, 0}, {0, 0, 0}, 1, 0.5), ShapeError);
    CHECK_THROWS_AS(makeOffset<3>(shape, -0.5), ShapeError);
    CHECK_THROWS_AS(makeOffset<3>(shape, 1.5), ShapeError);
}

TEST_CASE("a cylinder answers by closed forms") {
    const auto shape = makeCylinder({0, 0, 1}, {0, 0, 4}, 0.5);
    CHECK(shape->measure() == Approx(0.75 * std::numbers::pi));
    CHECK(shape->contains({0.5, 0, 4}));
    CHECK(shape->contains({0, -0.5, 1}));
    CHECK_FALSE(shape->contains({0, 0, std::nextafter(4, 5)}));
    CHECK_FALSE(shape->contains({0, 0, std::nextafter(1, 0)}));
    CHECK(shape->signedDistance({0, 0, 2.5}) == -0.5);
    CHECK(shape->signedDistance({0, 0, 3.75}) == -0.25);
    CHECK(shape->signedDistance({2, 0, 2}) == 1.5);
    CHECK(shape->signedDistance({0.2, 0, 0}) == 1);
    CHECK(shape->signedDistance({3.5, 0, 8}) == 5);
    CHECK(shape->normal({0.4, 0, 2}) == Point(1, 0, 0));
    CHECK(shape->normal({0.1, 0, 3.9}) == Point(0, 0, 1));
    CHECK(shape->normal({0.1, 0, 0.9}) == Point(0, 0, -1));
    CHECK(shape->normal({3.5, 0, 8}).isApprox(Point(0.6, 0, 0.8), 1e-15));
    CHECK(std::abs(shape->normal({0, 0, 2.5}).z()) < 1e-15);
    CHECK(shape->normal({0, 0, 2.5}).norm() == Approx(1).epsilon(1e-15));
    CHECK(shape->bounds().lower == Point(-0.5, -0.5, 1));
    CHECK(shape->bounds().upper == Point(0.5, 0.5, 4));
    // Askew: the rim reaches r sqrt(1 - a_i^2).
    const auto skew = makeCylinder({0, 0, 0}, {3, 4, 0}, 1);
    CHECK(skew->bounds().upper.isApprox(Point(3.8, 4.6, 1), 1e-14));
}

TEST_CASE("booleans of solids by their signed distances") {
    const auto a = makeBox<3>({0, 0, 0}, {2, 2, 2}), b = makeBall<3>({2, 1, 1}, 0.5);
    CHECK(std::isnan(makeUnion<3>({a, b})->measure()));
    const auto both = makeUnion<3>({a, b});
    const auto common = makeIntersection<3>({a, b});
    const auto rest = makeDifference<3>({a, b});
    CHECK(both->contains({2.4, 1, 1}));
    CHECK(both->signedDistance({3, 1, 1}) == 0.5);
    CHECK(both->normal({2.4, 1, 1}) == Point(1, 0, 0));
    CHECK(both->bounds().upper == Point(2.5, 2, 2));
    CHECK(common->contains({1.75, 1, 1}));
    CHECK_FALSE(common->contains({2.25, 1, 1}));
    CHECK_FALSE(common->contains({1, 1, 1}));
    CHECK(common->bounds().lower == Point(1.5, 0.5, 0.5));
    CHECK(common->bounds().upper == Point(2, 1.5, 1.5));
    CHECK(rest->contains({1, 1, 1}));
    CHECK_FALSE(rest->contains({1.75, 1, 1}));
    CHECK(rest->contains({1.5, 1, 1}));  // closed: the surface of what was taken away stays
    CHECK(rest->signedDistance({1.75, 1, 1}) == 0.25);
    CHECK(rest->normal({1.25, 1, 1}) == Point(1, 0, 0));
    CHECK(rest->bounds().upper == Point(2, 2, 2));
    CHECK(makeIntersection<3>({a, makeBall<3>({9, 9, 9}, 1)})->empty());
    CHECK_FALSE(rest->empty());
}

TEST_CASE("offsets of solids keep edges sharp") {
    const auto inside = makeBox<3>({0, 0, 0}, {2, 2, 2});
    const auto grown = makeOffset<3>(inside, 0.5);
    CHECK(grown->contains({-0.5, -0.5, -0.5}));
    CHECK(grown->bounds().upper == Point(2.5, 2.5, 2.5));
    CHECK(makeOffset<3>(makeBall<3>({0, 0, 0}, 1), -0.25)->signedDistance({0, 0, 0}) == -0.75);
    const auto rod = makeOffset<3>(makeCylinder({0, 0, 0}, {0, 0, 2}, 1), 0.5);
    CHECK(rod->contains({1.5, 0, 2.5}));
    CHECK(rod->bounds().lower == Point(-1.5, -1.5, -0.5));

    // A tank wall that grows closes in on its inside too.
    const auto wall = makeOffset<3>(makeDifference<3>({grown, inside}), 0.25);
    CHECK(wall->contains({-0.75, 1, 1}));
    CHECK(wall->contains({0.25, 1, 1}));
    CHECK_FALSE(wall->contains({0.3, 1, 1}));
    CHECK(wall->bounds().upper == Point(2.75, 2.75, 2.75));
    // What was taken away has closed.
    CHECK(makeOffset<3>(makeDifference<3>({grown, inside}), 1)->signedDistance({1, 1, 1}) == -2.5);
    // One of two vanishes; turned and scaled boxes.
    const auto pair = makeUnion<3>({inside, makeBall<3>({9, 0, 0}, 0.25)});
    CHECK(makeOffset<3>(pair, -0.5)->bounds().upper == Point(1.5, 1.5, 1.5));
    const auto turned = makeRotated(inside, 0.3, {0, 0, 0}, {1, 1, 1});
    CHECK(makeOffset<3>(turned, 0.5)->signedDistance({1, 1, 1}) == Approx(-1.5).epsilon(1e-14));
}

TEST_CASE("normals of solids are gradients") {
    Random random(31);
    const auto a = makeRotated(makeBox<3>({0, 0, 0}, {1, 2, 3}), 0.5, {0, 0, 0}, {1, 2, 3});
    const auto b = makeCylinder({0, 0, 0}, {1, 1, 1}, 0.5);
    const auto c = makeBall<3>({1, 1, 1}, 0.8);
    const std::vector<ShapePointer<3>> shapes{
        a, b, c, makeUnion<3>({a, b}), makeDifference<3>({a, c, b}), makeIntersection<3>({a, c})};
    for (const auto& shape : shapes) {
        for (int i = 0; i < 300; ++i) {
            const Point p(random.between(-1, 3), random.between(-1, 3), random.between(-1, 3));
            const double h = 1e-6;
            Point gradient;
            for (int axis = 0; axis < 3; ++axis) {
                const Point e = h * Point::Unit(axis);
                gradient[axis] =
                    (shape->signedDistance(p + e) - shape->signedDistance(p - e)) / (2 * h);
            }
            CHECK((shape->normal(p) - gradient).norm() < 1e-4);
            CHECK(shape->contains(p) == (shape->signedDistance(p) <= 0));
            if (shape->contains(p)) CHECK(shape->bounds().contains(p));
        }
    }
}

TEST_CASE("solids that cannot be made") {
    CHECK(
        messageOf([] {
            makeBox<3>({0, 0, 1}, {1, 1, 1});
        }) ==
        "the box has no extent along z: its upper corner (1, 1, 1) must lie above its lower corner "
        "(0, 0, 1) in every coordinate");
    CHECK(messageOf([] {
              makeBox<3>({0, 0, nan_value}, {1, 1, 1});
          }) == "lower corner (0, 0, nan) must be finite");
    CHECK(messageOf([] { makeBall<3>({0, 0, 0}, 0); }) == "radius is 0 but must be above 0");
    CHECK(messageOf([] {
              makeBall<3>({0, 0, 0}, nan_value);
          }) == "radius is nan but must be above 0");
    CHECK(messageOf([] {
              makeCylinder({1, 2, 3}, {1, 2, 3}, 1);
          }) == "the ends of the cylinder coincide at (1, 2, 3)");
    CHECK(messageOf([] {
              makeCylinder({0, 0, 0}, {1, 2, 3}, -1);
          }) == "radius is -1 but must be above 0");
    CHECK(messageOf([] { makeUnion<3>({}); }) == "a union needs at least one shape");
    CHECK(messageOf([] {
              makeOffset<3>(makeBox<3>({0, 0, 0}, {1, 2, 3}), -0.5);
          }) == "offset -0.5 leaves nothing of a shape of size 1 x 2 x 3");
    CHECK(messageOf([] {
              makeOffset<3>(makeCylinder({0, 0, 0}, {0, 0, 1}, 2), -0.5);
          }) == "offset -0.5 leaves nothing of a shape of size 4 x 4 x 1");
}
