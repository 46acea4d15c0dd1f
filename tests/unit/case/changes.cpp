// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/changes.h"

#include "case/language/read.h"
#include "case/run/physics_text.h"
#include "case/run/show.h"
#include "registry.h"

#include <catch2/catch.hpp>

using namespace sphinx;

namespace {

model::Case read(const std::string& text) {
    return language::readCaseText("case.yaml", text, test::registry());
}

std::string sorted(int version) {
    return test::blockOfWater(version) + R"yaml(dynamics:
  neighbors: {type: neighbors.update, bodies: [water]}
  sort: {type: particles.sort, body: water}
loop: {end_time: 1, start: [neighbors], layer: all, dt: 0.1, steps: [sort, neighbors]}
outputs: {frames: {type: vtu}, saved: {type: restart}}
)yaml";
}

std::string warningsOf(const model::Case& model, int version,
                       const std::vector<language::LanguageChange>& changes) {
    input::Diagnostics diagnostics;
    language::warnChanges(model, version, changes, diagnostics);
    return diagnostics.text();
}

}  // namespace

TEST_CASE("a case of an older version is told what has changed, and the resolved one is not") {
    const model::Case old = read(sorted(1));
    CHECK_THAT(old.warnings, Catch::StartsWith("case.yaml:13:11: warning: since version 2 of the "
                                               "language frames hold the particles in the order"));
    CHECK(old.warnings.find("warning", 30) == std::string::npos);
    const std::string shown = run::showCase(old);
    CHECK_THAT(shown, Catch::StartsWith("sphinx: 2 "));
    CHECK(read(shown).warnings.empty());
    CHECK(read(sorted(2)).warnings.empty());
}

TEST_CASE("a version that leaves the state alone leaves the physics of a restart alone") {
    CHECK(run::physicsText(read(sorted(1))) == run::physicsText(read(sorted(2))));
    model::Case newer = read(sorted(2));
    newer.state_version = 2;
    CHECK(run::physicsText(newer) != run::physicsText(read(sorted(2))));
}

TEST_CASE("the version of the state is that of the newest change that concerns the case") {
    const model::Case model = read(sorted(1));
    const auto everywhere = [](const model::Case& c) {
        return std::vector<input::Place>{c.bodies[0].place};
    };
    const auto nowhere = [](const model::Case&) { return std::vector<input::Place>{}; };
    const std::vector<language::LanguageChange> changes{{2, true, everywhere, "fluids are wetter"},
                                                        {3, true, nowhere, "solids are harder"},
                                                        {4, false, everywhere, "files are longer"}};
    CHECK(language::stateVersion(model, changes) == 2);
    CHECK(language::stateVersion(model, {}) == 1);
    CHECK_THAT(warningsOf(model, 1, changes),
               Catch::Contains("version 2 of the language fluids") &&
                   Catch::Contains("version 4 of the language files"));
    CHECK_THAT(warningsOf(model, 2, changes), !Catch::Contains("fluids are wetter"));
    CHECK(warningsOf(model, 4, changes).empty());
}
