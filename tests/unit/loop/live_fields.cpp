// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/live_fields.h"
#include "dam_break_facts.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

using Names = std::set<std::string>;

TEST_CASE("a restart of the dam break holds what the next step reads") {
    const auto live = liveFields(DamBreak().facts());
    REQUIRE(live.size() == 2);
    // Not pressure (written before it is read), not external_acceleration (zeroed).
    CHECK(live.at("water") ==
          Names{"id", "position", "velocity", "mass", "density", "density_rate"});
    CHECK(live.at("wall") == Names{"id", "position", "normal"});
}

TEST_CASE("velocity belongs to the restart of every body that has one") {
    LoopFacts facts = DamBreak().facts();
    facts.bodies[1].initial.push_back("velocity");
    CHECK(liveFields(facts).at("wall").count("velocity") == 1);
}

TEST_CASE("what is read now and then is live when the loop does not write it") {
    LoopFacts facts = DamBreak().facts();
    facts.plan.start.push_back(line(3, "mark", {write("wall", "color")}));
    CHECK(liveFields(facts).at("wall").count("color") == 0);
    look(facts, read("wall", "color"));
    CHECK(liveFields(facts).at("wall").count("color") == 1);
}

TEST_CASE("a write under every does not end the life of a field") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    Call turn = line(5, "turn", {write("wall", "normal")}, {}, true);
    facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(), {turn});
    CHECK(liveFields(facts).at("wall").count("normal") == 1);
    turn.every = {};
    facts.plan.outermost.steps[0] = {turn};
    CHECK(liveFields(facts).at("wall").count("normal") == 0);
}

TEST_CASE("an accumulated field that is read before it is zeroed is live") {
    LoopFacts facts = DamBreak().facts();
    facts.bodies[0].initial.push_back("external_acceleration");
    Call look = line(5, "look", {read("water", "external_acceleration")});
    facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(), {look});
    CHECK(liveFields(facts).at("water").count("external_acceleration") == 1);
}

TEST_CASE("a value carried within an inner layer only is not live") {
    LoopFacts facts = DamBreak().facts();
    const Call begin = line(5, "begin", {write("water", "mean")});
    const Call sum = line(6, "sum", {read("water", "mean"), write("water", "mean")});
    facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(), {begin});
    std::get<Layer>(facts.plan.outermost.steps[3].value).steps.push_back({sum});
    CHECK(liveFields(facts).at("water").count("mean") == 0);
    facts.plan.outermost.steps.erase(facts.plan.outermost.steps.begin());
    CHECK(liveFields(facts).at("water").count("mean") == 1);
}
