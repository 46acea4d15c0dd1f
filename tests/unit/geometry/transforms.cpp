// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <catch2/catch.hpp>
#include <numbers>

using namespace sphinx;
using namespace sphinx::geometry;
using std::numbers::pi;

TEST_CASE("transforms of a box are exact where axes stay axes") {
    const auto shape = box(0, 0, 2, 1);
    const auto moved = makeTranslated<2>(shape, {0.1, -0.3});
    CHECK(moved->bounds().lower == Vec<2>(0.1, -0.3));
    CHECK(moved->bounds().upper == Vec<2>(2.1, 0.7));
    const auto turned = makeRotated(shape, pi / 2, {0, 0});
    CHECK(turned->bounds().lower == Vec<2>(-1, 0));
    CHECK(turned->bounds().upper == Vec<2>(0, 2));
    CHECK(makeRotated(shape, -1.5 * pi, {0, 0})->bounds().lower == Vec<2>(-1, 0));
    CHECK(makeRotated(shape, pi, {1, 1})->bounds().lower == Vec<2>(0, 1));
    const auto scaled = makeScaled<2>(shape, 3, {2, 1});
    CHECK(scaled->bounds().lower == Vec<2>(-4, -2));
    CHECK(scaled->measure() == 18);
    const auto mirrored = makeMirrored<2>(shape, {2, 0}, {5, 0});
    CHECK(mirrored->bounds().lower == Vec<2>(2, 0));
    CHECK(mirrored->bounds().upper == Vec<2>(4, 1));
    CHECK(mirrored->measure() == 2);
    CHECK(mirrored->normal({3.9, 0.5}) == Vec<2>(1, 0));
    CHECK(makeMirrored<2>(shape, {0, 0}, {1, -1})->bounds().upper == Vec<2>(1, 2));
}

TEST_CASE("a rotation turns counter-clockwise by its angle") {
    const auto shape = makeRotated(box(0, 0, 2, 1), pi / 6, {0, 0});
    const Vec<2> along(std::cos(pi / 6), std::sin(pi / 6));
    CHECK(shape->signedDistance(3 * along) == Approx(1).epsilon(1e-14));
    CHECK(shape->contains(1.9 * along + Vec<2>(-0.01, 0.02)));
    CHECK(shape->measure() == Approx(2).epsilon(1e-15));
}

TEMPLATE_TEST_CASE_SIG("transforms compose, and carry distances and normals along", "",
                       ((int Dim), Dim), 2, 3) {
    Random random(17);
    const Vec<Dim> center = Vec<Dim>::LinSpaced(0.3, -0.7);
    const Vec<Dim> direction = Vec<Dim>::LinSpaced(1, 2);
    const auto turn = [&](const ShapePointer<Dim>& shape, double angle) {
        if constexpr (Dim == 2) return makeRotated(shape, angle, center);
        if constexpr (Dim == 3) return makeRotated(shape, angle, center, direction);
    };
    std::vector<ShapePointer<Dim>> shapes{makeBox<Dim>(Vec<Dim>::Zero(), Vec<Dim>::LinSpaced(1, 2)),
                                          makeBall<Dim>(center, 0.75)};
    shapes.push_back(makeUnion<Dim>({shapes[0], shapes[1]}));
    shapes.push_back(makeDifference<Dim>({shapes[0], shapes[1]}));
    if constexpr (Dim == 2) shapes.push_back(makePolygon(randomStar(random, 50)));
    if constexpr (Dim == 3) shapes.push_back(makeCylinder({0, 0, 0}, {1, 0.5, -1}, 0.4));
    for (const auto& shape : shapes) {
        const auto there = makeTranslated<Dim>(shape, direction);
        const auto back = makeTranslated<Dim>(there, -direction);
        const auto twice = turn(turn(shape, 0.4), 0.5), once = turn(shape, 0.9);
        const auto full = turn(turn(shape, 1.2), -1.2);
        const auto large = makeScaled<Dim>(shape, 2.5, center);
        const auto image = makeMirrored<Dim>(shape, center, direction);
        const auto image_of_image = makeMirrored<Dim>(image, center, direction);
        // A mirror commutes with turns about its normal, and in the plane inverts a turn.
        const auto scaled_image =
            makeMirrored<Dim>(makeScaled<Dim>(once, 2.5, center), center, direction);
        const auto all = turn(scaled_image, Dim == 2 ? 0.9 : -0.9);
        for (int i = 0; i < 100; ++i) {
            Vec<Dim> p;
            for (double& x : p) x = random.between(-1.5, 2.5);
            const double distance = shape->signedDistance(p);
            const Vec<Dim> reflected =
                p - 2 * (p - center).dot(direction) / direction.squaredNorm() * direction;
            CHECK(there->signedDistance(p + direction) == Approx(distance).margin(1e-13));
            CHECK(back->signedDistance(p) == Approx(distance).margin(1e-13));
            CHECK(twice->signedDistance(p) == Approx(once->signedDistance(p)).margin(1e-13));
            CHECK(full->signedDistance(p) == Approx(distance).margin(1e-13));
            CHECK(large->signedDistance(center + 2.5 * (p - center)) ==
                  Approx(2.5 * distance).margin(1e-13));
            CHECK(image->signedDistance(reflected) == Approx(distance).margin(1e-13));
            CHECK(image_of_image->signedDistance(p) == Approx(distance).margin(1e-13));
            CHECK(all->signedDistance(center + 2.5 * (reflected - center)) ==
                  Approx(2.5 * distance).margin(1e-13));
            if (std::abs(distance) < 1e-6) continue;
            const Vec<Dim> n = shape->normal(p);
            CHECK((there->normal(p + direction) - n).norm() < 1e-9);
            CHECK((large->normal(center + 2.5 * (p - center)) - n).norm() < 1e-9);
            const Vec<Dim> turned = image->normal(reflected);
            CHECK(
                (turned - (n - 2 * n.dot(direction) / direction.squaredNorm() * direction)).norm() <
                1e-9);
        }
    }
}

TEST_CASE("transforms keep areas") {
    Random random(23);
    const auto shape =
        makeDifference<2>({makePolygon(randomStar(random, 80)), box(-0.1, -0.1, 0.1, 0.1)});
    CHECK(makeMirrored<2>(shape, {0.2, 0.7}, {1, 3})->measure() ==
          Approx(shape->measure()).epsilon(1e-13));
    CHECK(makeRotated(shape, 0.77, {3, 1})->measure() == Approx(shape->measure()).epsilon(1e-13));
    CHECK(makeScaled<2>(shape, 0.5, {3, 1})->measure() ==
          Approx(shape->measure() / 4).epsilon(1e-13));
    // A mirrored shape still works in booleans and offsets.
    const auto image = makeMirrored<2>(shape, {0, 0}, {1, 0});
    CHECK(makeOffset<2>(image, 0.05)->measure() ==
          Approx(makeOffset<2>(shape, 0.05)->measure()).epsilon(1e-12));
    CHECK(makeIntersection<2>({image, box(0, -2, 2, 2)})->measure() ==
          Approx(makeIntersection<2>({shape, box(-2, -2, 0, 2)})->measure()).epsilon(1e-12));
}

TEST_CASE("impossible transforms are errors") {
    const auto shape = box(0, 0, 1, 1);
    const auto solid = makeBall<3>({0, 0, 0}, 1);
    CHECK(messageOf([&] { makeScaled<2>(shape, 0, {0, 0}); }) == "factor is 0 but must be above 0");
    CHECK(messageOf([&] {
              makeScaled<2>(shape, -2, {0, 0});
          }) == "factor is -2 but must be above 0");
    CHECK(messageOf([&] {
              makeScaled<2>(shape, 2, {0, nan_value});
          }) == "center (0, nan) must be finite");
    CHECK(messageOf([&] {
              makeTranslated<2>(shape, {0, nan_value});
          }) == "translation (0, nan) must be finite");
    CHECK(messageOf([&] { makeRotated(shape, nan_value, {0, 0}); }) == "angle nan must be finite");
    CHECK(messageOf([&] {
              makeRotated(solid, 1, {0, 0, 0}, {0, 0, 0});
          }) == "the axis of a rotation must not be zero");
    CHECK(messageOf([&] {
              makeMirrored<2>(shape, {0, 0}, {0, 0});
          }) == "the normal of a mirror must not be zero");
}
