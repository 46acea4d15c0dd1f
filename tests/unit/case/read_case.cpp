// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/access.h"
#include "case/language/read.h"
#include "case/run/show.h"
#include "core/errors.h"
#include "registry.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

using namespace sphinx;

namespace {

const char* const dam_break = R"yaml(sphinx: 2
title: dam break
dimension: 2
units: {length: mm, time: ms, mass: mg}
variables: {spacing: 0.5 cm, depth: 10 cm, wave: 2 m/s}
resolution: {spacing: spacing, kernel: quintic_spline}
domain: {lower: [-50, -50], upper: [450, 350], periodic: [x], lost_particles: remove}
geometry:
  column: {box: {lower: [0, 0], upper: [200, depth]}}
  wall:
    difference:
      - {offset: {shape: inside, by: 4*spacing}}
      - inside
  inside: {box: {lower: [0, 0], upper: [400, 300]}}
  corner: {translate: {shape: {circle: {radius: 5}}, by: [200, 100]}}
materials:
  water: {type: weakly_compressible_fluid, density: 1, sound_speed: 20 m/s}
  rigid: {type: rigid}
bodies:
  water:
    kind: fluid
    shape: column
    material: water
    initial: {velocity: ["wave*sin(x/depth)", 0], pressure: "9.81e-3*(depth - y)"}
  wall: {kind: solid, shape: wall, material: rigid, resolution: {level: 1}, parts: {tip: corner}}
  gauge: {kind: observer, line: {from: [100, 0], to: [100, 100], points: 5}, follows: material}
  sensor: {kind: observer, area: {from: [400, 10], edges: [[0, 20]], points: [4]}}
  tracers: {kind: solid, material: rigid, particles: [[10, 20, 25], [15, 20, 25]]}
topology:
  water: [self, wall]
  gauge: [water]
dynamics:
  gravity: {type: force.gravity, body: water, acceleration: [0, -9.81 m/s^2]}
  relaxation: {type: fluid.pressure_relaxation, body: water}
  advection_dt: {type: fluid.advection_time_step, body: water, reference_speed: wave}
  acoustic_dt: {type: fluid.acoustic_time_step, body: water}
  sort: {type: particles.sort, body: water}
  neighbors: {type: neighbors.update, bodies: [water]}
loop:
  end_time: 1 s
  start: [neighbors]
  layer: advection
  dt: [advection_dt, 5 ms]
  steps:
    - gravity
    - layer: acoustic
      dt: acoustic_dt
      fit: clip
      steps: [relaxation.first_half, relaxation.second_half]
    - {run: sort, every: {steps: 100, layer: acoustic}}
    - neighbors
)yaml";

model::Case read(const std::string& text) {
    return language::readCaseText("case.yaml", text, test::registry());
}

std::string errorOf(const std::string& text) {
    try {
        read(text);
    } catch (const CaseError& e) {
        return e.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("A case becomes plain data in case units") {
    const model::Case c = read(dam_break);
    CHECK(c.warnings.empty());
    CHECK(c.dimension == 2);
    CHECK(c.resolution.spacing == 5);
    CHECK(c.resolution.kernel == kernels::KernelType::quintic_spline);
    CHECK(c.domain.periodic == std::vector<int>{0});
    CHECK(c.domain.lost == bodies::LostParticles::remove);
    CHECK(c.domain.upper->as<2>() == Vec<2>(450, 350));

    const model::Body& water = *c.findBody("water");
    CHECK(water.role == bodies::Role::fluid);
    CHECK(water.spacing(c.resolution) == 5);
    CHECK((*water.initial.velocity)[0](Vec<2>(50, 0), 0) == 2 * std::sin(0.5));
    CHECK((*water.initial.velocity)[1].constant());
    CHECK((*water.initial.pressure)(Vec<2>(0, 90), 0) == 9.81e-3 * 10);
    const model::Body& wall = *c.findBody("wall");
    CHECK(wall.spacing(c.resolution) == 2.5);
    CHECK(wall.parts.at(0).name == "tip");
    CHECK(c.findBody("gauge")->points.at(1).as<2>() == Vec<2>(100, 25));
    CHECK(c.findBody("gauge")->follows.what == model::Follows::material);
    CHECK(c.findBody("sensor")->points.at(3).as<2>() == Vec<2>(400, 27.5));
    CHECK(c.findBody("tracers")->particles->points.at(1).as<2>() == Vec<2>(15, 20));
    CHECK(c.findBody("tracers")->particles->volumes == std::vector<double>{25, 25});
    CHECK(c.findBody("nobody") == nullptr);
    CHECK(c.seenBy("water").at(0).body.text == "water");
    CHECK(c.seenBy("sensor").empty());

    CHECK(c.findShape("wall")->as<2>()->contains(Vec<2>(-10, 10)));
    CHECK(!c.findShape("wall")->as<2>()->contains(Vec<2>(10, 10)));
    CHECK(c.findShape("corner")->as<2>()->contains(Vec<2>(203, 100)));

    CHECK(c.loop.end_time == 1000);
    CHECK(c.loop.dt.methods.at(0).text == "advection_dt");
    CHECK(c.loop.dt.number == 5);
    const model::Layer& acoustic = *c.loop.steps.at(1).layer;
    CHECK(acoustic.fit == loop::Fit::clip);
    CHECK(acoustic.steps.at(1).method() == "relaxation");
    CHECK(c.loop.steps.at(2).every->layer.text == "acoustic");
    CHECK(c.loop.steps.at(2).every->steps == 100);
    CHECK(c.findMethod("gravity")->place.line > 1);
    CHECK(c.findMethod("gravity")->placeOf("body").column > 10);
}

TEST_CASE("Accesses name the bodies of the case") {
    const model::Case c = read(dam_break);
    const auto accesses = build::resolveAccesses(c, *c.findMethod("relaxation"), 0);
    const auto has = [&](input::AccessMode mode, const char* body, const char* field) {
        return std::any_of(accesses.begin(), accesses.end(), [&](const dynamics::FieldAccess& a) {
            return a.mode == mode && a.body == body && a.field == field;
        });
    };
    CHECK(has(input::AccessMode::write, "water", "velocity"));
    CHECK(has(input::AccessMode::read, "wall", "normal"));
    CHECK(!has(input::AccessMode::read, "water", "normal"));
    CHECK(!has(input::AccessMode::write, "wall", "velocity"));
}

TEST_CASE("The resolved case says where values come from, and is stable") {
    const model::Case c = read(dam_break);
    const std::string shown = run::showCase(c);
    CHECK(std::regex_search(shown, std::regex("sound_speed: 20 +# case.yaml:17")));
    CHECK(std::regex_search(shown, std::regex("start_time: 0 +# default")));
    CHECK(std::regex_search(shown, std::regex("wave: 2 +# case.yaml:5")));  // still used
    CHECK(shown.find("spacing: 0.5 cm") == std::string::npos);

    const std::regex origins(" +# [^\n]*");
    const model::Case again = read(shown);
    CHECK(std::regex_replace(run::showCase(again), origins, "") ==
          std::regex_replace(shown, origins, ""));
    CHECK(again.loop.end_time == c.loop.end_time);
    CHECK((*again.findBody("water")->initial.velocity)[0](Vec<2>(50, 0), 0) ==
          (*c.findBody("water")->initial.velocity)[0](Vec<2>(50, 0), 0));
}

TEST_CASE("What the author defined and nobody uses is warned of") {
    const model::Case c = read(replaced(dam_break, "variables: {", "variables: {unused: 1, "));
    CHECK(c.warnings.find("5:13: warning: the variable 'unused' is never used") !=
          std::string::npos);
}

TEST_CASE("Shapes of one dimension are refused in the other") {
    CHECK(errorOf(replaced(dam_break, "{circle: {radius: 5}}", "{sphere: {radius: 5}}"))
              .find("sphere exists in 3D only, and the case is 2D") != std::string::npos);
}

TEST_CASE("A 3D case") {
    const model::Case c = read(R"yaml(sphinx: 2
dimension: 3
resolution: {spacing: 0.1}
geometry:
  ball: {sphere: {center: [0, 0, 1], radius: 0.5}}
  tube: {rotate: {shape: {cylinder: {from: [0, 0, 0], to: [1, 0, 0], radius: 0.2}}, angle: 90 deg, axis: [0, 0, 1]}}
  both: {union: [ball, tube]}
materials: {water: {type: weakly_compressible_fluid, density: 1000, sound_speed: 20}}
bodies: {water: {kind: fluid, shape: both, material: water, initial: {pressure: 1000*z}}}
dynamics: {neighbors: {type: neighbors.update, bodies: [water]}}
loop: {end_time: 1, layer: all, dt: 0.1, steps: [neighbors]}
)yaml");
    CHECK(c.findShape("both")->as<3>()->contains(Vec<3>(0, 0.9, 0)));
    CHECK(c.findShape("both")->as<3>()->contains(Vec<3>(0, 0, 1.4)));
    CHECK(!c.findShape("both")->as<3>()->contains(Vec<3>(0.9, 0, 0)));
    CHECK((*c.findBody("water")->initial.pressure)(Vec<3>(0, 0, 2), 0) == 2000);
}
