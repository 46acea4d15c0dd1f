// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/simulation.h"

#include "../io/support.h"
#include "case/language/read.h"
#include "registry.h"

#include <catch2/catch.hpp>

#include <map>

using namespace sphinx;

namespace {

const char* const falling_block = R"yaml(sphinx: 1
dimension: 2
units: none
resolution: {spacing: 0.1}
geometry:
  square: {box: {lower: [0, 0], upper: [1, 1]}}
domain: {lower: [-9, -9], upper: [9, 9]}
materials:
  water: {type: weakly_compressible_fluid, density: 1, sound_speed: 10}
bodies:
  water: {kind: fluid, shape: square, material: water, initial: {velocity: [y, 0]}}
topology:
  water: [self]
dynamics:
  gravity:    {type: force.gravity, body: water, acceleration: [0, -1]}
  relaxation: {type: fluid.pressure_relaxation, body: water}
  neighbors:  {type: neighbors.update, bodies: [water]}
loop:
  end_time: 0.05
  start: [neighbors]
  layer: acoustic
  dt: 0.005
  steps: [gravity, relaxation.first_half, relaxation.second_half, neighbors]
)yaml";

model::Case fallingBlock() {
    return language::readCaseText("falling_block.yaml", falling_block, test::registry());
}

std::map<std::int64_t, Vec<2>> placesById(run::Simulation<2>& simulation) {
    particles::ParticleSet<2>& particles = simulation.world().find("water")->particles;
    std::map<std::int64_t, Vec<2>> places;
    for (std::size_t i = 0; i < particles.size(); ++i)
        places[particles.id()[i]] = particles.position()[i];
    return places;
}

}  // namespace

TEST_CASE("a simulation is stepped, looked at, left and taken up again") {
    const test::TemporaryFolder folder;
    const model::Case model = fallingBlock();
    run::RunOptions without;
    without.outputs = false;
    run::Simulation<2> whole(model, without, folder.path(), {});
    whole.prepare();
    whole.begin();
    const auto start = placesById(whole);
    CHECK(start.size() == 100);
    int steps = 0;
    for (; !whole.finished(); ++steps) whole.step();
    whole.end();
    CHECK(steps == 10);
    CHECK(whole.clock().time == Approx(0.05));
    const auto end = placesById(whole);
    double fallen = 0;
    for (const auto& [id, place] : end) fallen += (place - start.at(id))[1] / 100;
    CHECK(fallen == Approx(-0.5 * 0.05 * 0.05));
    CHECK(std::filesystem::is_empty(folder.path()));

    const run::RunOptions fresh;
    run::Simulation<2> first(model, fresh, folder.path(), {});
    first.prepare();
    first.begin();
    for (int k = 0; k < 4; ++k) first.step();
    CHECK_FALSE(first.finished());
    first.end();

    run::RunOptions resumed;
    resumed.resume = true;
    run::Simulation<2> second(model, resumed, folder.path(), {});
    second.prepare();
    CHECK(second.clock().steps == 4);
    CHECK(placesById(second) == placesById(first));
    second.begin();
    while (!second.finished()) second.step();
    CHECK(placesById(second) == end);
}
