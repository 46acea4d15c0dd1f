// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dam_break_facts.h"
#include "loop/flow/live_fields.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

/// The dam break with two relaxations, one until 1 and the other from then on.
struct Shared : DamBreak {
    Call other_first = limited(first_half, 1.0, {});
    Call other_second = limited(second_half, 1.0, {});

    Shared() {
        other_first.id = 24;
        other_second.id = 25;
        first_half.window.until = second_half.window.until = 1.0;
    }
    LoopFacts facts(std::vector<Step> acoustic_steps) const {
        LoopFacts facts = DamBreak::facts();
        std::get<Layer>(facts.plan.outermost.steps[2].value).steps = std::move(acoustic_steps);
        return facts;
    }
};

}  // namespace

TEST_CASE("two methods that share the time of a run are as good as one") {
    Shared lines;
    for (const auto& steps : std::vector<std::vector<Step>>{
             {{lines.first_half}, {lines.other_first}, {lines.second_half}, {lines.other_second}},
             {{lines.first_half},
              {lines.second_half},
              {lines.other_first},
              {lines.other_second}}}) {
        LoopFacts facts = lines.facts(steps);
        CHECK(found(facts).empty());
        CHECK(liveFields(facts) == liveFields(DamBreak().facts()));
    }
    SECTION("three of them, in the outer layer as well") {
        LoopFacts facts = lines.facts({{lines.first_half},
                                       {limited(lines.other_first, 1.0, 2.0)},
                                       {limited(lines.other_first, 2.0, {})},
                                       {lines.second_half},
                                       {lines.other_second}});
        facts.plan.outermost.steps[0] = {limited(lines.density, {}, 1.5)};
        facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(),
                                          {limited(lines.density, 1.5, {})});
        CHECK(found(facts).empty());
    }
}

TEST_CASE("what is written in a part of the time only is not there in the rest") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    const Call mark = line(14, "mark", {write("wall", "mark")});
    const Call look = line(15, "look", {read("wall", "mark")});
    const auto with = [&](const Call& first, const Call& second) {
        LoopFacts changed = facts;
        changed.plan.outermost.steps.insert(changed.plan.outermost.steps.begin(),
                                            {{first}, {second}});
        return found(changed);
    };
    const Messages from_1{
        "15 error look reads mark of wall, which mark writes only at times from 1: let "
        "it be written in the other steps before it is read, or in start"};
    CHECK(with(limited(mark, 1.0, {}), look) == from_1);
    CHECK(with(limited(mark, 1.0, {}), limited(look, 0.5, {})) == from_1);
    CHECK(with(limited(mark, 1.0, {}), limited(look, 1.0, 3.0)).empty());
    CHECK(with(limited(mark, 1.0, {}), limited(look, 2.0, {})).empty());
    // A step may reach over the whole window.
    CHECK(with(limited(mark, 1.0, 1.1), limited(look, 2.0, {})) ==
          Messages{
              "15 error look reads mark of wall, which mark writes only at times from 1 until 1.1: "
              "let it be written in the other steps before it is read, or in start"});
    // The first step is within its window.
    CHECK(with(limited(mark, {}, 1.0), limited(look, {}, 1.0)).empty());
    // What a former step has written is there.
    CHECK(with(limited(look, 1.0, {}), mark).empty());
    CHECK(
        with(look, mark) ==
        Messages{"15 error look reads mark of wall before mark has written it: call mark earlier, "
                 "or in start"});
    SECTION("start makes it good") {
        facts.plan.start.push_back(mark);
        CHECK(with(limited(mark, 1.0, {}), look).empty());
    }
    SECTION("and the time of the start counts") {
        facts.plan.start_time = 1;
        CHECK(with(limited(mark, 1.0, {}), look).empty());
    }
}

TEST_CASE("an inner layer comes to a window before the layer around it") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    const Call mark = line(14, "mark", {write("wall", "mark")});
    const Call look = line(15, "look", {read("wall", "mark")});
    facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(), {limited(mark, 1.0, {})});
    std::get<Layer>(facts.plan.outermost.steps[3].value).steps.push_back({limited(look, 1.0, {})});
    CHECK(found(facts).size() == 1);
    std::get<Layer>(facts.plan.outermost.steps[3].value).steps.back() = {limited(look, 2.0, {})};
    CHECK(found(facts).size() == 1);  // as long as a step may be
}

TEST_CASE("lists that are updated in a part of the time only") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    facts.plan.outermost.steps.erase(facts.plan.outermost.steps.end() - 2);  // the sort
    facts.plan.outermost.steps.back() = {limited(lines.neighbors, {}, 1.0)};
    CHECK(found(facts) ==
          Messages{"22 error pressure_relaxation.first_half moves water, but at times from 1 no "
                   "line of the loop updates the neighbors of water: call neighbors after it"});
    append(facts, {limited(lines.neighbors, 1.0, {})});
    CHECK(found(facts).empty());
}

TEST_CASE("an acceleration may be added in a part of the time") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    facts.plan.outermost.steps[1] = {limited(lines.gravity, 1.0, 2.0)};
    CHECK(found(facts).empty());
    SECTION("also where nothing reads it for a while") {
        Layer& acoustic = std::get<Layer>(facts.plan.outermost.steps[2].value);
        acoustic.steps = {{limited(lines.first_half, {}, 1.5)},
                          {limited(lines.second_half, {}, 1.5)}};
        CHECK(found(facts).empty());
    }
    SECTION("but not where nothing reads it then") {
        Layer& acoustic = std::get<Layer>(facts.plan.outermost.steps[2].value);
        acoustic.steps = {{limited(lines.first_half, {}, 1.0)},
                          {limited(lines.second_half, {}, 1.0)}};
        CHECK(found(facts).size() == 1);
    }
}

TEST_CASE("a field that is read in a part of the time only is live in all of it") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    facts.plan.start.push_back(line(3, "mark", {write("wall", "mark")}));
    const Call look = line(15, "look", {read("wall", "mark")});
    append(facts, {limited(look, 1.0, 2.0)});
    CHECK(liveFields(facts).at("wall").count("mark") == 1);
}
