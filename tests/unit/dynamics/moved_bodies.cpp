// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
// Whoever moves particles says so by the version of their body: outputs look at any substep.
#include "../scene/stepper.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

TEST_CASE("each half of a fluid's step makes lists stale") {
    Scene<2> scene;
    Body<2>& water = scene.fluid("water", scene.lattice(5));
    const auto relaxation =
        scene.method("type: fluid.pressure_relaxation, body: water, riemann: none");
    scene.relations.update({&water});
    const std::uint64_t version = water.version;
    relaxation.run({0, 1e-3, 0}, "first_half");
    const std::uint64_t between = water.version;
    CHECK(between > version);
    relaxation.run({0, 1e-3, 0}, "second_half");
    CHECK(water.version > between);
}

TEST_CASE("each half of an elastic body's step makes lists stale") {
    Scene<2> scene;
    Body<2>& body = scene.elastic("block", scene.lattice(10, 0.2));
    Stepper<2> stepper(scene, body);
    const std::uint64_t version = body.version;
    stepper.relaxation.run({0, 1e-5, 0}, "first_half");
    const std::uint64_t between = body.version;
    CHECK(between > version);
    stepper.relaxation.run({0, 1e-5, 0}, "second_half");
    CHECK(body.version > between);
}

TEST_CASE("lists are stale when particles come back on the other side of a periodic domain") {
    Scene<2> scene;
    Body<2>& water = scene.fluid("water", {Vec<2>(0.1, 0.5), Vec<2>(0.9, 0.5)});
    scene.repeat(0, Vec<2>(0, 0), Vec<2>(1, 1));
    const auto update = scene.method("type: neighbors.update, bodies: [water]");
    update.run({});
    const std::uint64_t version = water.version;
    update.run({});
    CHECK(water.version == version);
    Vec<2>& x = water.particles.position()[1];
    x[0] = 1.01;
    update.run({});
    CHECK(x[0] == Approx(0.01));
    CHECK(water.version > version);
}
