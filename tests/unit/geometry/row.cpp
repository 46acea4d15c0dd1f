// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::geometry;

namespace {

/// Number of points that differ; `inside_count` grows by the points found inside.
int differences(const Shape<2>& shape, const Vec<2>& first, double step, std::size_t count,
                int& inside_count) {
    std::vector<std::uint8_t> row(count + 1, 7);
    shape.rowContains(first, step, count, row.data());
    int wrong = row[count] == 7 ? 0 : 1;  // nothing written behind the end
    for (std::size_t k = 0; k < count; ++k) {
        const bool inside = shape.contains({rowAbscissa(first.x(), step, k), first.y()});
        if (row[k] != (inside ? 1 : 0)) ++wrong;
        inside_count += inside;
    }
    return wrong;
}

}  // namespace

TEST_CASE("rows agree with points on random polygons") {
    Random random(3);
    for (int trial = 0; trial < 20; ++trial) {
        const auto shape = makePolygon(randomStar(random, 3 + 20 * trial));
        int wrong = 0, inside = 0;
        for (int row = 0; row < 60; ++row) {
            const Vec<2> first(random.between(-1.3, 0), random.between(-1.1, 1.1));
            wrong += differences(*shape, first, random.between(0.001, 0.02), 150, inside);
        }
        CHECK(wrong == 0);
        CHECK(inside > 100);
    }
}

TEST_CASE("rows agree with points where the lattice meets corners and edges") {
    // All corners and edges lie on lattice points: horizontal, vertical, diagonal, with a hole.
    const auto outer =
        makePolygon({{0, 0}, {8, 0}, {8, 4}, {6, 4}, {6, 2}, {4, 4}, {2, 2}, {0, 4}});
    const auto shape =
        makeDifference<2>({outer, makePolygon({{1, 1}, {2, 0.5}, {3, 1}, {2, 1.5}})});
    int wrong = 0, inside = 0;
    for (int row = -4; row <= 40; ++row) {
        wrong += differences(*shape, {-1, row * 0.125}, 0.125, 81, inside);
    }
    CHECK(wrong == 0);
    CHECK(inside > 1000);

    std::vector<std::uint8_t> bottom(6);
    outer->rowContains({-1, 0}, 2, 6, bottom.data());
    CHECK(bottom == std::vector<std::uint8_t>{0, 1, 1, 1, 1, 0});
    std::vector<std::uint8_t> top(6);
    outer->rowContains({-2, 4}, 2, 6, top.data());
    CHECK(top == std::vector<std::uint8_t>{0, 1, 0, 1, 1, 1});
}

TEST_CASE("rows of circles, of solids, and against the direction agree with points") {
    int inside = 0;
    CHECK(differences(*makeBall<2>({0, 0}, 0.5), {-0.6, 0.1}, 0.01, 120, inside) == 0);
    CHECK(differences(*box(0, 0, 1, 1), {1.5, 0.5}, -0.125, 20, inside) == 0);
    CHECK(differences(*box(0, 0, 1, 1), {0.5, 0.5}, 0, 3, inside) == 0);
    CHECK(inside == 97 + 9 + 3);
    const auto solid = makeBall<3>({0, 0, 0}, 1);
    std::uint8_t row[5];
    solid->rowContains({-2, 0, 0}, 1, 5, row);
    CHECK(std::vector<std::uint8_t>(row, row + 5) == std::vector<std::uint8_t>{0, 1, 1, 1, 0});
}
