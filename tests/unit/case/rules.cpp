// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/rules.h"

#include "case/build/world.h"
#include "case/language/read.h"
#include "case/language/register.h"
#include "core/errors.h"
#include "registry.h"

#include <catch2/catch.hpp>

using namespace sphinx;

namespace {

struct PushParameters {
    double strength = 0;
};

template <int Dim>
struct Push final : dynamics::Method {
    Push(dynamics::Context<Dim>&, const PushParameters&) {}
    void run(const Clock&) {}
    std::size_t workSize() const override { return 0; }
};

/// What was asked, as "TYPE: RULE of METHOD".
std::vector<std::string> asked;

void note(const std::string& type, const std::string& rule) { asked.push_back(type + ": " + rule); }

/// A method with a rule of each kind.
template <const char* type>
void declarePush(input::Registry& registry) {
    using P = PushParameters;
    auto& d = dynamics::declareMethod<Push, P>(registry, type);
    d.required("strength", &P::strength, input::number(unit::none), "");
    d.action();
    d.rule([](const input::Component& method, dynamics::WrittenCase& written) {
        note(type, "rule of " + method.name);
        if (method.as<P>().strength >= 1000)
            written.diagnostics.error(method.placeOf("strength"), method.name + " breaks");
    });
    d.worldRule([](const input::Component& method, auto& built) {
        note(type, "world rule of " + method.name);
        if (method.as<P>().strength > static_cast<double>(built.world.find("water")->size()))
            built.diagnostics.error(method.placeOf("strength"), method.name + " outweighs");
    });
    d.caseRule([](auto& built) {
        note(type, "case rule");
        built.diagnostics.warning(built.methods.front()->place, "there are pushes");
    });
}

constexpr char push[] = "test.push";
constexpr char shove[] = "test.shove";

const char* const two_pushes = R"yaml(dynamics:
  neighbors: {type: neighbors.update, bodies: [water]}
  late: {type: test.push, strength: 101}
  later: {type: test.push, strength: LATER}
loop: {end_time: 1, start: [neighbors], layer: all, dt: 0.1, steps: [neighbors, late]}
)yaml";

model::Case read(const std::string& strength) {
    static input::Registry all;
    if (all.names(input::Kind::dynamics).empty()) {
        language::registerAll(all);
        declarePush<push>(all);
        declarePush<shove>(all);
    }
    std::string text = test::blockOfWater(2) + two_pushes;
    text.replace(text.find("LATER"), 5, strength);
    asked.clear();
    return language::readCaseText("case.yaml", text, all);
}

using Asked = std::vector<std::string>;

}  // namespace

TEST_CASE("rules of the case as it is written are asked of each use, where it stands") {
    read("1");
    CHECK(asked == Asked{"test.push: rule of late", "test.push: rule of later"});
    CHECK_THROWS_WITH(read("1000"), Catch::StartsWith("case.yaml:12:38: error: later breaks"));
}

TEST_CASE("rules about particles are asked of each use, and those of the case once") {
    const model::Case model = read("102");
    asked.clear();
    input::Diagnostics diagnostics;
    build::buildWorld<2>(model, true, diagnostics);
    // Nothing in the case is of the type test.shove: only its rule about the whole case is asked.
    CHECK(asked == Asked{"test.push: world rule of late", "test.push: world rule of later",
                         "test.push: case rule", "test.shove: case rule"});

    // Messages stand in the order of the case, whoever was asked first; the same one stands once.
    CHECK(diagnostics.errors() == 2);
    const std::string text = diagnostics.text();
    const auto warning = text.find("case.yaml:10:3: warning: there are pushes\n");
    const auto late = text.find("case.yaml:11:37: error: late outweighs\n");
    const auto later = text.find("case.yaml:12:38: error: later outweighs\n");
    CHECK(warning == 0);
    CHECK(late != text.npos);
    CHECK(later != text.npos);
    CHECK(late < later);
    CHECK(text.find("there are pushes", warning + 40) == text.npos);
}

TEST_CASE("without particles no rule about them is asked") {
    const model::Case model = read("102");
    asked.clear();
    input::Diagnostics diagnostics;
    build::buildWorld<2>(model, false, diagnostics);
    CHECK(asked.empty());
}
