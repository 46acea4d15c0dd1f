// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/changes.h"

#include "case/language/read.h"
#include "case/run/physics_text.h"
#include "case/run/show.h"
#include "registry.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::model;

namespace {

Case read(const std::string& text) { return readCaseText("case.yaml", text, test::registry()); }

std::string sorted(int version) {
    return "sphinx: " + std::to_string(version) + R"yaml(
dimension: 2
resolution: {spacing: 0.1}
geometry: {block: {box: {lower: [0, 0], upper: [1, 1]}}}
materials: {water: {type: weakly_compressible_fluid, density: 1000, sound_speed: 20}}
bodies: {water: {kind: fluid, shape: block, material: water}}
topology: {water: [self]}
dynamics:
  neighbors: {type: neighbors.update, bodies: [water]}
  sort: {type: particles.sort, body: water}
loop: {end_time: 1, start: [neighbors], layer: all, dt: 0.1, steps: [sort, neighbors]}
outputs: {frames: {type: vtu}, saved: {type: restart}}
)yaml";
}

std::string warningsOf(const Case& model, int version, const std::vector<LanguageChange>& changes) {
    input::Diagnostics diagnostics;
    warnChanges(model, version, changes, diagnostics);
    return diagnostics.text();
}

}  // namespace

TEST_CASE("a case of an older version is told what has changed, and the resolved one is not") {
    const Case old = read(sorted(1));
    CHECK_THAT(old.warnings, Catch::StartsWith("case.yaml:12:11: warning: since version 2 of the "
                                               "language frames hold the particles in the order"));
    CHECK(old.warnings.find("warning", 30) == std::string::npos);
    const std::string shown = showCase(old);
    CHECK_THAT(shown, Catch::StartsWith("sphinx: 2 "));
    CHECK(read(shown).warnings.empty());
    CHECK(read(sorted(2)).warnings.empty());
}

TEST_CASE("a version that leaves the state alone leaves the physics of a restart alone") {
    CHECK(physicsText(read(sorted(1))) == physicsText(read(sorted(2))));
    Case newer = read(sorted(2));
    newer.state_version = 2;
    CHECK(physicsText(newer) != physicsText(read(sorted(2))));
}

TEST_CASE("the version of the state is that of the newest change that concerns the case") {
    const Case model = read(sorted(1));
    const auto everywhere = [](const Case& c) { return std::vector<Place>{c.bodies[0].place}; };
    const auto nowhere = [](const Case&) { return std::vector<Place>{}; };
    const std::vector<LanguageChange> changes{{2, true, everywhere, "fluids are wetter"},
                                              {3, true, nowhere, "solids are harder"},
                                              {4, false, everywhere, "files are longer"}};
    CHECK(stateVersion(model, changes) == 2);
    CHECK(stateVersion(model, {}) == 1);
    CHECK_THAT(warningsOf(model, 1, changes),
               Catch::Contains("version 2 of the language fluids") &&
                   Catch::Contains("version 4 of the language files"));
    CHECK_THAT(warningsOf(model, 2, changes), !Catch::Contains("fluids are wetter"));
    CHECK(warningsOf(model, 4, changes).empty());
}
