// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_elevation.h"

#include "entry.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::measure;
using namespace sphinx::test;

namespace {

template <int Dim>
std::vector<double> elevations(Scene<Dim>& scene, bodies::Body<Dim>& observer) {
    return rowOf(*makeElevationSource<Dim>(observer, nullptr, {}, outputContext(scene)));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the height of a flat surface is found within a hundredth of a spacing", "",
                       ((int Dim), Dim), 2, 3) {
    using V = Vec<Dim>;
    Scene<Dim> scene;
    V upper = V::Ones();
    upper[Dim - 1] = 0.6;
    bodies::Body<Dim>& water = scene.fluid("water", scene.box(V::Zero(), upper));
    std::vector<V> points;
    for (const double x : {0.41, 0.45, 0.5, 0.57}) {
        points.push_back(V::Constant(0.5));
        points.back()[0] = x;
        points.back()[Dim - 1] = 3 * x;  // wherever on the gauge
    }
    const std::vector<double> row = elevations(scene, scene.observer(points, {&water}));
    REQUIRE(row.size() == 4 + 4 * Dim);
    for (int k = 0; k < 4; ++k) {
        CHECK(std::abs(row[k] - 0.6) < 0.01 * scene.spacing);
        CHECK(row[4 + k * Dim] == points[k][0]);
    }
}

TEMPLATE_TEST_CASE_SIG("at a wall the fluid fills what the wall leaves", "", ((int Dim), Dim), 2,
                       3) {
    using V = Vec<Dim>;
    Scene<Dim> scene;
    V upper = V::Ones();
    upper[Dim - 1] = 0.6;
    bodies::Body<Dim>& water = scene.fluid("water", scene.box(V::Zero(), upper));
    V wall_lower = V::Constant(-0.4), wall_upper = V::Constant(1.4);
    wall_upper[0] = 0;
    bodies::Body<Dim>& wall = scene.wall("wall", scene.box(wall_lower, wall_upper));
    water.sees = {&water, &wall};
    std::vector<V> points;
    for (const double x : {-0.2, 0.0, 0.01, 0.05, 0.1, 0.5}) {
        points.push_back(V::Constant(0.5));
        points.back()[0] = x;
    }
    const std::vector<double> row = elevations(scene, scene.observer(points, {&water}));
    CHECK(std::isnan(row[0]));  // inside of the wall
    for (int k = 1; k < 6; ++k) CHECK(std::abs(row[k] - 0.6) < 0.02 * scene.spacing);
}

TEST_CASE("heights are measured against gravity") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    bodies::Body<2>& probe = scene.observer({Vec<2>(0.5, 0.5)}, {&water});
    water.fluid().gravity = Vec<2>(-3, 0);
    CHECK(elevations(scene, probe)[0] == Approx(1).margin(1e-3));
    water.fluid().gravity = Vec<2>(0, 2);  // upwards: the surface is at y = 0, the height is -y
    CHECK(elevations(scene, probe)[0] == Approx(0).margin(1e-3));
}

TEST_CASE("the surface is the highest place that fluid fills to a half; drops do not count") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 0.5)));
    bodies::Body<2>& probe = scene.observer({Vec<2>(0.55, 0), Vec<2>(1.6, 0)}, {&water});
    scene.place(water, {Vec<2>(0.55, 1.25)});
    std::vector<double> row = elevations(scene, probe);
    CHECK(row[0] == Approx(0.5).margin(1e-3));
    CHECK(std::isnan(row[1]));  // nothing there
    // A sheet of four layers above the surface counts.
    scene.place(water, scene.box(Vec<2>(0, 1.6), Vec<2>(1, 2)));
    row = elevations(scene, probe);
    CHECK(row[0] == Approx(2).margin(1e-3));
}

TEST_CASE("a slope is found where it crosses the gauge") {
    Scene<2> scene;
    scene.spacing = 0.02;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    std::vector<Index> dry;
    const auto height = [](double x) { return 0.4 + 0.2 * x; };
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Vec<2>& x = water.particles.position()[i];
        if (x[1] > height(x[0])) dry.push_back(static_cast<Index>(i));
    }
    water.particles.remove(dry);
    bodies::Body<2>& probe =
        scene.observer({Vec<2>(0.3, 0), Vec<2>(0.5, 0), Vec<2>(0.7, 0)}, {&water});
    const std::vector<double> row = elevations(scene, probe);
    // The particles form stairs of one spacing.
    for (int k = 0; k < 3; ++k)
        CHECK(std::abs(row[k] - height(0.3 + 0.2 * k)) < 0.25 * scene.spacing);
}

TEST_CASE("points above each other are one gauge, also across a periodic boundary") {
    Scene<2> scene;
    scene.repeat(0, Vec<2>(0, 0), Vec<2>(1, 1));
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 0.5)));
    bodies::Body<2>& probe = scene.observer(
        {Vec<2>(0, 0), Vec<2>(0, 0.1), Vec<2>(0, 0.2), Vec<2>(1, 0), Vec<2>(0.5, 0)}, {&water});
    const std::vector<double> row = elevations(scene, probe);
    REQUIRE(row.size() == 2 + 4);
    CHECK(row[0] == Approx(0.5).margin(1e-3));
    CHECK(row[1] == Approx(0.5).margin(1e-3));
}

TEST_CASE("the surface of a case is written like any series") {
    TemporaryFolder folder;
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 0.5)));
    bodies::Body<2>& probe = scene.observer({Vec<2>(0.25, 0), Vec<2>(3, 0)}, {&water});
    const Entry entry("{type: observe, observer: probe, quantity: surface_elevation}");
    entry.make(outputContext(scene, folder.path()))->write(clockAt(0));
    const std::string text = readFile(folder / "row.csv", 1000);
    CHECK_THAT(text, Catch::StartsWith("time [s],elevation_0 [m],elevation_1 [m],position_0_x [m],"
                                       "position_0_y [m],position_1_x [m],position_1_y [m]\n"));
    CHECK_THAT(text, Catch::EndsWith(",nan,0.25,0,3,0\n"));
    probe.sees = {&scene.wall("wall", {})};
    CHECK_THAT(errorOf([&] { entry.make(outputContext(scene, folder.path())); }),
               Catch::Contains("the observer 'probe' sees no fluid"));
}
