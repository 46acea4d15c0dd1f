// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe.h"

#include "../scene/values.h"
#include "entry.h"
#include "measure/observe_weights.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::measure;
using namespace sphinx::test;

namespace {

/// The sum of V W over a lattice at h = 1.3 spacings is 1 within this, wherever the point lies.
constexpr double lattice = 0.012;

template <int Dim>
ObserveSource<Dim> observe(Scene<Dim>& scene, bodies::Body<Dim>& observer,
                           const std::vector<const particles::FieldInfo*>& fields,
                           bool mean = false) {
    std::vector<std::vector<const particles::FieldBase*>> found;
    for (const particles::FieldInfo* info : fields) {
        found.emplace_back();
        for (bodies::Body<Dim>* body : observer.sees)
            found.back().push_back(&body->particles.require(*info));
    }
    return ObserveSource<Dim>(std::make_unique<ObserveWeights<Dim>>(observer, scene.relations),
                              std::move(found), mean, {});
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a constant is observed exactly, with the part of space around in particles",
                       "[observe]", ((int Dim), Dim), 2, 3) {
    using V = Vec<Dim>;
    Scene<Dim> scene;
    bodies::Body<Dim>& water = scene.fluid("water", scene.box(V::Zero(), V::Ones()));
    give(water, fields::velocity, [](const V&) -> V { return V::Constant(0.7); });
    V surface = V::Constant(0.5);
    surface[Dim - 1] = 1;  // the top face
    bodies::Body<Dim>& probe =
        scene.observer({V::Constant(0.5), V::Constant(0.437), surface}, {&water});
    auto source = observe(scene, probe, {&fields::velocity});
    const std::vector<double> row = rowOf(source);
    REQUIRE(row.size() == 3 * Dim + 3 + 3 * Dim);
    for (int k = 0; k < 3 * Dim; ++k) CHECK(row[k] == Approx(0.7).epsilon(1e-14));
    const double* coverage = row.data() + 3 * Dim;
    CHECK(coverage[0] == Approx(1).epsilon(lattice));
    CHECK(coverage[1] == Approx(1).epsilon(lattice));
    CHECK(coverage[2] == Approx(0.5).epsilon(lattice));
    for (int k = 0; k < Dim; ++k) CHECK(row[5 * Dim + 3 + k] == surface[k]);
}

TEST_CASE("a linear field is observed exactly where particles lie symmetrically", "[observe]") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    const auto linear = [](const Vec<2>& x) { return 3 + 2 * x[0] - 5 * x[1]; };
    give(water, fields::pressure, linear);
    // On a particle, between four of them, and between two.
    bodies::Body<2>& probe =
        scene.observer({Vec<2>(0.45, 0.55), Vec<2>(0.5, 0.4), Vec<2>(0.5, 0.45)}, {&water});
    auto source = observe(scene, probe, {&fields::pressure});
    const std::vector<double> row = rowOf(source);
    // Distances in lists are floats.
    for (int k = 0; k < 3; ++k)
        CHECK(row[k] == Approx(linear(probe.particles.position()[k])).epsilon(1e-7));
}

TEST_CASE("a point without particles near is NaN and covers nothing", "[observe]") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    give(water, fields::pressure, [](const Vec<2>&) { return 4; });
    bodies::Body<2>& probe = scene.observer({Vec<2>(0.5, 0.5), Vec<2>(0.5, 1.5)}, {&water});
    auto points = observe(scene, probe, {&fields::pressure});
    std::vector<double> row = rowOf(points);
    CHECK(row[0] == Approx(4));
    CHECK(std::isnan(row[1]));
    CHECK(row[3] == 0);

    SECTION("the mean leaves it out") {
        auto mean = observe(scene, probe, {&fields::pressure}, true);
        row = rowOf(mean);
        REQUIRE(row.size() == 4);
        CHECK(row[0] == Approx(4));
        CHECK(row[1] == Approx(0.5).epsilon(lattice));
        CHECK(row[2] == 0.5);
        CHECK(row[3] == 1);
    }
}

TEST_CASE("all bodies that an observer sees count, each with its own kernel", "[observe]") {
    Scene<2> scene;
    bodies::Body<2>& left = scene.fluid("left", scene.box(Vec<2>(0, 0), Vec<2>(0.5, 1)));
    scene.spacing = 0.05;
    bodies::Body<2>& right = scene.fluid("right", scene.box(Vec<2>(0.5, 0), Vec<2>(1, 1)));
    scene.spacing = 0.1;
    give(right, fields::pressure, [](const Vec<2>&) { return 1; });
    bodies::Body<2>& probe =
        scene.observer({Vec<2>(0.2, 0.5), Vec<2>(0.5, 0.5), Vec<2>(0.8, 0.5)}, {&left, &right});
    auto source = observe(scene, probe, {&fields::pressure});
    const std::vector<double> row = rowOf(source);
    CHECK(row[0] == 0);
    CHECK(row[1] == Approx(0.5).epsilon(lattice));
    CHECK(row[2] == Approx(1));
    for (int k = 3; k < 6; ++k) CHECK(row[k] == Approx(1).epsilon(lattice));
}

TEST_CASE("observers look through periodic boundaries", "[observe]") {
    Scene<2> scene;
    scene.repeat(0, Vec<2>(0, 0), Vec<2>(1, 1));
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    bodies::Body<2>& probe = scene.observer({Vec<2>(0, 0.5)}, {&water});
    auto source = observe(scene, probe, {&fields::pressure});
    CHECK(rowOf(source)[1] == Approx(1).epsilon(lattice));
}

TEST_CASE("an observer sees where particles are now", "[observe]") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(0.5, 0.5)));
    bodies::Body<2>& probe = scene.observer({Vec<2>(1, 0.25)}, {&water});
    auto source = observe(scene, probe, {&fields::pressure});
    CHECK(rowOf(source)[1] == 0);
    for (std::size_t i = 0; i < water.size(); ++i) water.particles.position()[i][0] += 0.75;
    ++water.version;
    CHECK(rowOf(source)[1] == Approx(1).epsilon(lattice));
}

TEST_CASE("columns of an observer are named by point and component", "[observe]") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    const auto labelsOf = [&](const std::vector<Vec<2>>& points, bool mean) {
        auto source = observe(scene, scene.observer(points, {&water}),
                              {&fields::pressure, &fields::velocity, &strain}, mean);
        std::vector<std::string> labels;
        for (const io::SeriesQuantity& quantity : source.quantities()) {
            if (quantity.labels.empty()) labels.push_back(quantity.name);
            for (const std::string& label : quantity.labels)
                labels.push_back(quantity.name + "_" + label);
        }
        return labels;
    };
    const std::vector<std::string> single{"pressure",   "velocity_x", "velocity_y", "strain_xx",
                                          "strain_xy",  "strain_yx",  "strain_yy",  "coverage",
                                          "position_x", "position_y"};
    CHECK(labelsOf({Vec<2>(0, 0)}, false) == single);
    CHECK(labelsOf({Vec<2>(0, 0), Vec<2>(0, 1)}, true) == single);
    CHECK(labelsOf({Vec<2>(0, 0), Vec<2>(0, 1)}, false) ==
          std::vector<std::string>{"pressure_0",   "pressure_1",   "velocity_0_x", "velocity_0_y",
                                   "velocity_1_x", "velocity_1_y", "strain_0_xx",  "strain_0_xy",
                                   "strain_0_yx",  "strain_0_yy",  "strain_1_xx",  "strain_1_xy",
                                   "strain_1_yx",  "strain_1_yy",  "coverage_0",   "coverage_1",
                                   "position_0_x", "position_0_y", "position_1_x", "position_1_y"});
}

TEST_CASE("matrices are observed row by row", "[observe]") {
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    particles::Field<Mat<2>>& tensor = water.particles.matrix(strain);
    for (std::size_t i = 0; i < water.size(); ++i) tensor[i] << 1, 2, 3, 4;
    auto source = observe(scene, scene.observer({Vec<2>(0.5, 0.5)}, {&water}), {&strain});
    const std::vector<double> row = rowOf(source);
    for (int k = 0; k < 4; ++k) CHECK(row[k] == Approx(k + 1));
}

TEST_CASE("an observer of a case writes its rows", "[observe]") {
    TemporaryFolder folder;
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    give(water, fields::pressure, [](const Vec<2>&) { return 0.25; });
    scene.observer({Vec<2>(0.5, 2)}, {&water});
    const Entry entry("{type: observe, observer: probe, fields: [pressure]}");
    auto output = entry.make(outputContext(scene, folder.path()));
    CHECK_FALSE(output->sampledLayer());
    output->write(clockAt(1.5));
    output->finish();
    CHECK(readFile(folder / "row.csv", 1000) ==
          "time [s],pressure [Pa],coverage,position_x [m],position_y [m]\n1.5,nan,0,0.5,2\n");
}

TEST_CASE("what an observer cannot do is an error at its place", "[observe]") {
    TemporaryFolder folder;
    Scene<2> scene;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    bodies::Body<2>& probe = scene.observer({Vec<2>(0.5, 0.5)}, {&water});
    const auto error = [&](const std::string& yaml, bool follows = false) {
        return errorOf([&] {
            io::OutputContext<2> context = outputContext(scene, folder.path());
            if (follows) context.followers.emplace_back(&probe);
            Entry(yaml).make(context);
        });
    };
    using Catch::Contains;
    using Catch::StartsWith;
    CHECK(error("{type: observe, observer: probe, fields: [pressure]}").empty());
    CHECK_THAT(error("{type: observe, observer: probe}"),
               Contains("an observer needs either 'fields' or 'quantity'"));
    CHECK_THAT(error("{type: observe, observer: probe, fields: [density], quantity: "
                     "surface_elevation}"),
               Contains("either 'fields' or 'quantity'"));
    CHECK_THAT(error("{type: observe, observer: probe, fields: [presure]}"),
               StartsWith("case.yaml:1:43: error: 'water' has no field 'presure' in this case; did "
                          "you mean 'pressure'?\n"));
    CHECK_THAT(error("{type: observe, observer: probe, fields: [id]}"),
               StartsWith("case.yaml:1:43: error: 'id' cannot be interpolated"));
    CHECK_THAT(error("{type: observe, observer: probe, fields: [position]}"),
               StartsWith("case.yaml:1:43: error: the position of the points is always written"));
    CHECK_THAT(error("{type: observe, observer: probe, fields: [density, density]}"),
               StartsWith("case.yaml:1:52: error: the field 'density' is named twice"));
    CHECK_THAT(error("{type: observe, observer: probe, mean: true, quantity: surface_elevation}"),
               StartsWith("case.yaml:1:40: error: 'mean' is for fields"));
    CHECK_THAT(error("{type: observe, observer: probe, quantity: surface_elevation}", true),
               Contains("'probe' follows the material"));
    probe.sees.clear();
    CHECK_THAT(error("{type: observe, observer: probe, fields: [density]}"),
               Contains("the observer 'probe' sees no body"));
}
