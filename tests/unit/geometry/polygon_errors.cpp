// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "random_shapes.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::geometry;

namespace {

std::string polygonError(const std::vector<Vec<2>>& points) {
    return messageOf([&] { makePolygon(points); });
}

}  // namespace

TEST_CASE("polygons that are none are refused by name") {
    CHECK(polygonError({}) == "a polygon needs at least 3 points, this one has 0");
    CHECK(polygonError({{0, 0}, {1, 1}}) == "a polygon needs at least 3 points, this one has 2");
    CHECK(polygonError({{0, 0}, {1, nan_value}, {1, 1}}) ==
          "point 2 is (1, nan); coordinates must be finite numbers");
    CHECK(polygonError({{0, 0}, {1, 0}, {std::numeric_limits<double>::infinity(), 1}}) ==
          "point 3 is (inf, 1); coordinates must be finite numbers");
    CHECK(polygonError({{0, 0}, {1, 0}, {1, 1}, {0, 0}}) ==
          "the last point (0, 0) repeats the first; a polygon closes by itself");
    CHECK(polygonError({{0, 0}, {1, 0}, {1, 0}, {1, 1}}) == "points 2 and 3 are equal: (1, 0)");
    CHECK(polygonError({{0, 0}, {1, 1}, {3, 3}, {2, 2}}) == "all points lie on one line");
}

TEST_CASE("edges that meet are named") {
    const std::string rule = "; edges may meet only where one ends and the next begins";
    CHECK(polygonError({{0, 0}, {1, 1}, {1, 0}, {0, 1}}) ==
          "edge 1 from (0, 0) to (1, 1) crosses edge 3 from (1, 0) to (0, 1)" + rule);
    // A corner on a foreign edge, and two corners in one place.
    CHECK(polygonError({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}) ==
          "edge 1 from (0, 0) to (2, 0) touches edge 3 from (2, 1) to (1, 0)" + rule);
    CHECK(polygonError({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}) ==
          "edge 1 from (0, 0) to (1, 1) touches edge 4 from (2, 2) to (1, 1)" + rule);
    // Back along the same line, at the next corner and at the closing one.
    CHECK(polygonError({{0, 0}, {2, 0}, {1, 0}, {1, 1}}) ==
          "edge 1 from (0, 0) to (2, 0) runs along edge 2 from (2, 0) to (1, 0)" + rule);
    CHECK(polygonError({{1, 0}, {2, 0}, {2, 1}, {3, 0}}) ==
          "edge 1 from (1, 0) to (2, 0) runs along edge 4 from (3, 0) to (1, 0)" + rule);
}

TEST_CASE("points in line on a side are allowed") {
    CHECK(makePolygon({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}})->measure() == 2);
    CHECK(makeOffset<2>(makePolygon({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), 1)->measure() == 12);
}

TEST_CASE("one crossing among thousands of edges is found") {
    std::vector<Vec<2>> points;
    for (int k = 0; k < 5000; ++k) points.emplace_back(std::cos(k / 800.0), std::sin(k / 800.0));
    CHECK(polygonError(points) == "no ShapeError");
    std::swap(points[1234], points[1235]);
    CHECK_THAT(polygonError(points),
               Catch::StartsWith("edge 1234 ") && Catch::Contains(" edge 1236 "));
}

TEST_CASE("2D primitives and booleans that cannot be made") {
    CHECK(messageOf([] {
              makeBox<2>({0, 1}, {1, 0});
          }) ==
          "the box has no extent along y: its upper corner (1, 0) must lie above its lower corner "
          "(0, 1) in every coordinate");
    CHECK(messageOf([] {
              makeBox<2>({0, 0}, {nan_value, 1});
          }) == "upper corner (nan, 1) must be finite");
    CHECK(messageOf([] { makeBall<2>({0, 0}, -1); }) == "radius is -1 but must be above 0");
    CHECK(messageOf([] { makeBall<2>({nan_value, 0}, 1); }) == "center (nan, 0) must be finite");
    CHECK(messageOf([] { makeUnion<2>({}); }) == "a union needs at least one shape");
    CHECK(messageOf([] { makeDifference<2>({}); }) == "a difference needs at least one shape");
    CHECK(messageOf([] { makeIntersection<2>({}); }) == "an intersection needs at least one shape");
}
