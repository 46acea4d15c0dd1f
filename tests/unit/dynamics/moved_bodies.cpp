// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
// Whoever moves particles says so by the version of their body: outputs look at any substep.
#include "dynamics/fluid/pressure_relaxation.h"
#include "dynamics/neighbors/update.h"
#include "fluid.h"
#include "stepper.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::test;

TEST_CASE("each half of a fluid's step makes lists stale") {
    FluidScene<2> scene(filled<2>(Vec<2>(0, 0), Vec<2>(0.5, 0.5), FluidScene<2>::spacing));
    fluid::PressureRelaxation<2> relaxation(scene.context, *scene.water, fluid::Riemann::none);
    scene.relations.update({scene.water});
    const std::uint64_t version = scene.water->version;
    relaxation.firstHalf({0, 1e-3, 0});
    const std::uint64_t between = scene.water->version;
    CHECK(between > version);
    relaxation.secondHalf({0, 1e-3, 0});
    CHECK(scene.water->version > between);
}

TEST_CASE("each half of an elastic body's step makes lists stale") {
    ElasticScene<2> scene;
    Body<2>& body = *scene.patch(false).front();
    Stepper<2> stepper(scene.context, body);
    const std::uint64_t version = body.version;
    stepper.relaxation.firstHalf({0, 1e-5, 0});
    const std::uint64_t between = body.version;
    CHECK(between > version);
    stepper.relaxation.secondHalf({0, 1e-5, 0});
    CHECK(body.version > between);
}

TEST_CASE("lists are stale when particles come back on the other side of a periodic domain") {
    FluidScene<2> scene({Vec<2>(0.1, 0.5), Vec<2>(0.9, 0.5)});
    scene.repeat(0, 1);
    neighbors::Update<2> update(scene.context, {scene.water});
    update.run({});
    const std::uint64_t version = scene.water->version;
    update.run({});
    CHECK(scene.water->version == version);
    Vec<2>& x = scene.water->particles.position()[1];
    x[0] = 1.01;
    update.run({});
    CHECK(x[0] == Approx(0.01));
    CHECK(scene.water->version > version);
}
