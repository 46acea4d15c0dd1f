// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dam_break_facts.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

TEST_CASE("lists that were never built") {
    LoopFacts facts = DamBreak().facts();
    facts.plan.start.erase(facts.plan.start.begin());
    CHECK(found(facts) == Messages{"12 error density_summation uses the neighbors of water before "
                                   "they were built: call neighbors in start"});
}

TEST_CASE("a loop that moves a body and never updates its lists") {
    LoopFacts facts = DamBreak().facts();
    facts.plan.outermost.steps.pop_back();
    SECTION("although start does") {
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half moves water, but no line of the "
                       "loop updates the neighbors of water: call neighbors after it"});
    }
    SECTION("and nothing does") {
        facts.plan.start.erase(facts.plan.start.begin());
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half moves water, but no line of the "
                       "loop updates the neighbors of water: add a method neighbors.update for "
                       "water and call it after it"});
    }
    SECTION("of a body whose lists nobody named") {
        facts.lists.clear();
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half moves water, but no line of the "
                       "loop updates the neighbors of water: call neighbors after it"});
    }
}

TEST_CASE("lists that are stale where up-to-date ones are needed") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    SECTION("in the next step") {
        lines.neighbors.every = now_and_then;
        facts.plan.outermost.steps.back() = {lines.neighbors};
        facts.plan.outermost.steps.erase(facts.plan.outermost.steps.end() - 2);  // the sort
        CHECK(found(facts) ==
              Messages{"12 error density_summation needs up-to-date neighbors of water, but "
                       "pressure_relaxation.second_half has moved water since they were built: "
                       "call neighbors between the two"});
    }
    SECTION("in the same step") {
        const Call level = line(33, "level", {read("water", "fresh_neighbors")});
        facts.plan.outermost.steps.insert(facts.plan.outermost.steps.end() - 2, {level});
        CHECK(found(facts) ==
              Messages{"33 error level needs up-to-date neighbors of water, but "
                       "pressure_relaxation.second_half has moved water since they were built: "
                       "call neighbors between the two"});
    }
    SECTION("in the next substep of an inner layer") {
        Layer& acoustic = std::get<Layer>(facts.plan.outermost.steps[2].value);
        lines.density.id = 25;
        acoustic.steps.insert(acoustic.steps.begin(), {lines.density});
        CHECK(found(facts) ==
              Messages{"25 error density_summation needs up-to-date neighbors of water, but "
                       "pressure_relaxation.second_half has moved water since they were built: "
                       "call neighbors between the two"});
    }
    SECTION("because another body of the list moves") {
        facts.bodies.push_back({"gate", true, {}});
        facts.lists.push_back({"water", "gate", false});
        CHECK(foundWith(facts, {line(26, "swing", {write("gate", "position")})}) ==
              Messages{"12 error density_summation needs up-to-date neighbors of water, but swing "
                       "has moved gate since they were built: call neighbors between the two"});
    }
}

TEST_CASE("lists of the reference configuration do not go stale") {
    LoopFacts facts = DamBreak().facts();
    facts.bodies.push_back({"gate", true, {}});
    facts.lists.push_back({"gate", "gate", true});
    facts.plan.start.push_back(line(3, "gate_lists", {write("gate", "neighbors")}));
    const Call stress =
        line(26, "stress", {read("gate", "fresh_neighbors"), write("gate", "position")});
    append(facts, {stress});
    CHECK(found(facts).empty());
    facts.lists.back().reference_configuration = false;
    CHECK(found(facts) == Messages{"26 error stress moves gate, but no line of the loop updates "
                                   "the neighbors of gate: call gate_lists after it"});
}

TEST_CASE("sorting makes lists invalid") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    SECTION("for the next step") {
        std::swap(facts.plan.outermost.steps[3], facts.plan.outermost.steps[4]);
        CHECK(found(facts) ==
              Messages{"12 error density_summation uses the neighbors of water, which sort has "
                       "made invalid: call neighbors in every step after sort"});
    }
    SECTION("also for methods that accept older lists") {
        facts.plan.outermost.steps.erase(facts.plan.outermost.steps.begin());
        std::swap(facts.plan.outermost.steps[2], facts.plan.outermost.steps[3]);
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half uses the neighbors of water, which "
                       "sort has made invalid: call neighbors in every step after sort"});
    }
    SECTION("of bodies that see the sorted one, reference configuration included") {
        facts.lists.push_back({"gauge", "water", true});
        append(facts, {line(42, "gauge", {read("gauge", "fresh_neighbors")}, {}, true)});
        CHECK(found(facts).empty());
        facts.plan.outermost.steps.insert(facts.plan.outermost.steps.end() - 1,
                                          {line(34, "sort_again", {}, {"water"})});
        CHECK(found(facts) ==
              Messages{"12 error density_summation uses the neighbors of water, which sort_again "
                       "has made invalid: call neighbors in every step after sort_again",
                       "42 error gauge uses the neighbors of gauge, which sort_again has made "
                       "invalid: call neighbors in every step after sort_again"});
    }
}

TEST_CASE("lists that a resumed run could not have") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    facts.plan.outermost.steps.erase(facts.plan.outermost.steps.begin());  // what needs fresh ones
    SECTION("rebuilt in some steps only") {
        lines.neighbors.every = now_and_then;
        facts.plan.outermost.steps = {{lines.gravity}, {lines.acoustic()}, {lines.neighbors}};
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half uses neighbors of water from "
                       "before pressure_relaxation.second_half moved water in the last step, which "
                       "a resumed run does not have: call neighbors in every step after "
                       "pressure_relaxation.second_half"});
    }
    SECTION("rebuilt between the halves") {
        facts.plan.outermost =
            layer(10, "only", {lines.acoustic_dt},
                  {{lines.gravity}, {lines.first_half}, {lines.neighbors}, {lines.second_half}});
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half uses neighbors of water from "
                       "before pressure_relaxation.second_half moved water in the last step, which "
                       "a resumed run does not have: call neighbors in every step after "
                       "pressure_relaxation.second_half"});
    }
    SECTION("rebuilt first thing in every step is fine") {
        facts.plan.outermost.steps = {{lines.neighbors}, {lines.gravity}, {lines.acoustic()}};
        CHECK(found(facts).empty());
    }
}
