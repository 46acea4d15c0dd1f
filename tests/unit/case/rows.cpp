// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/rows.h"

#include "../scene/bodies.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <vector>

using namespace sphinx;
using test::spacing;

namespace {

/// The points of a lattice of 40 x 40 cells (20 in 3D) about the origin for which inside(x) holds.
template <int Dim, class Inside>
std::vector<Vec<Dim>> points(Inside&& inside) {
    const double half = (Dim == 2 ? 20 : 10) * spacing;
    std::vector<Vec<Dim>> found;
    for (const Vec<Dim>& x : test::Bodies<Dim>().lattice(Dim == 2 ? 40 : 20, 0)) {
        const Vec<Dim> centred = x - Vec<Dim>::Constant(half);
        if (inside(centred)) found.push_back(centred);
    }
    return found;
}

template <int Dim, class Inside>
std::size_t rows(Inside&& inside) {
    test::Bodies<Dim> scene;
    return check::rowsAcross(scene.elastic("body", points<Dim>(inside)));
}

}  // namespace

TEST_CASE("rows across are those of the thin places of a body") {
    CHECK(rows<2>([](const Vec<2>& x) { return std::abs(x[1]) < 2 * spacing; }) == 4);
    CHECK(rows<3>([](const Vec<3>& x) { return std::abs(x[2]) < 3 * spacing; }) == 6);
    SECTION("of a ring its thickness") {
        const auto thick = rows<2>(
            [](const Vec<2>& x) { return x.norm() < 18 * spacing && x.norm() > 13 * spacing; });
        CHECK(thick >= 4);
        CHECK(thick <= 6);
    }
    SECTION("of a disc not the ends of its shortest chords") {
        CHECK(rows<2>([](const Vec<2>& x) { return x.norm() < 18 * spacing; }) > 14);
    }
    SECTION("of a plate between blocks that hold it those of the plate") {
        CHECK(rows<2>([](const Vec<2>& x) {
                  return std::abs(x[1]) < 3 * spacing || x[0] < -10 * spacing;
              }) == 6);
    }
}

TEST_CASE("bodies that are bonded bend as one") {
    test::Bodies<2> scene;
    auto& lower = scene.elastic(
        "lower", points<2>([](const Vec<2>& x) { return x[1] > -2 * spacing && x[1] < 0; }));
    auto& upper = scene.elastic(
        "upper", points<2>([](const Vec<2>& x) { return x[1] > 0 && x[1] < 3 * spacing; }));
    CHECK(check::rowsAcross(lower) == 2);
    lower.bonded = {&upper};
    upper.bonded = {&lower};
    CHECK(check::rowsAcross(lower) == 5);
    CHECK(check::rowsAcross(upper) == 5);
}

TEST_CASE("rows of particles that are fitted to a shape count along its normals") {
    test::Bodies<2> scene;
    auto& body = scene.elastic(
        "plate", points<2>([](const Vec<2>& x) { return std::abs(x[1]) < 2 * spacing; }));
    // A plate that lies askew in the lattice has as many rows as one along it.
    body.on_lattice = false;
    const auto plate =
        geometry::makeBox<2>({-20 * spacing, -2 * spacing}, {20 * spacing, 2 * spacing});
    body.shape = geometry::makeRotated(plate, 0.5, {0, 0});
    for (std::size_t i = 0; i < body.size(); ++i) {
        Vec<2>& x = body.particles.position()[i];
        x = Vec<2>(Eigen::Rotation2Dd(0.5) * x) + Vec<2>(0, 0.1 * spacing);
    }
    CHECK(check::rowsAcross(body) == 4);
}

TEST_CASE("what rows do to bending is said in words") {
    CHECK(check::bendingText(4, 0.197) == "4 rows across: bending about 20 % soft");
    CHECK(check::bendingText(1, 0.5) == "1 row across: bending about 50 % soft");
    CHECK(check::bendingText(4, -0.53) == "4 rows across: bending about 53 % stiff");
    CHECK(check::bendingText(30, 0.002) == "30 rows across: bending within 1 %");
    test::Bodies<2> scene;
    const auto& beam = scene.elastic("beam", scene.lattice(4, 0));
    CHECK(check::bendingError(4, beam) > 0);
    CHECK(check::bendingError(8, beam) < check::bendingError(4, beam) / 3);
}
