// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dam_break_facts.h"
#include "loop/flow/zeroing.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

TEST_CASE("nothing is wrong with the dam break") { CHECK(found(DamBreak().facts()).empty()); }

TEST_CASE("layers need a time step") {
    LoopFacts facts = DamBreak().facts();
    SECTION("the outermost") {
        facts.plan.outermost.dt.clear();
        CHECK(found(facts) ==
              Messages{"10 error the loop has no time step: give layer advection a dt"});
        facts.plan.outermost.fixed_dt = 1.0;
        CHECK(found(facts).empty());
    }
    SECTION("an inner one") {
        std::get<Layer>(facts.plan.outermost.steps[2].value).dt.clear();
        CHECK(found(facts) == Messages{"20 error layer acoustic has no time step: give it a dt"});
    }
}

TEST_CASE("a layer overshoots only where its parent can follow") {
    LoopFacts facts = DamBreak().facts();
    Layer& acoustic = std::get<Layer>(facts.plan.outermost.steps[2].value);
    Layer elastic{"elastic", {}, 1.0, Fit::overshoot, {}, 30};
    SECTION("inside a layer that splits") {
        acoustic.steps.push_back({elastic});
        CHECK(found(facts) ==
              Messages{"30 error layer elastic overshoots, but the layer acoustic around it has to "
                       "end at a given time: give that layer fit: overshoot as well"});
        acoustic.fit = Fit::overshoot;
        CHECK(found(facts).empty());
    }
    SECTION("after another layer") {
        CHECK(foundWith(facts, {elastic}) ==
              Messages{"30 error layer elastic overshoots and would leave layer acoustic behind, "
                       "which has covered the same step before it: put elastic first"});
    }
}

TEST_CASE("a body that should move and does not") {
    LoopFacts facts = DamBreak().facts();
    facts.bodies.push_back({"gate", true, {}});
    CHECK(found(facts) ==
          Messages{"10 warning gate never moves: no line of the loop writes its position"});
}

TEST_CASE("a field is read before anything wrote it") {
    DamBreak lines;
    LoopFacts facts = lines.facts();

    SECTION("nothing writes it") {
        facts.plan.start.pop_back();
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half reads normal of wall, which "
                       "nothing writes: call a method that computes it first"});
    }
    SECTION("one missing method is named once, with all that it would compute") {
        facts.plan.start.pop_back();
        facts.makers = {{"normals_from_shape", {"normal", "depth"}}, {"weights", {"mass"}}};
        look(facts, read("wall", "depth"));
        CHECK(
            found(facts) ==
            Messages{"22 error pressure_relaxation.first_half reads normal of wall, which nothing "
                     "computes: call a method of type normals_from_shape for wall first"});
        facts.makers.push_back({"other_normals", {"normal"}});  // which of them?
        facts.plan.outermost.steps.pop_back();
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half reads normal of wall, which "
                       "nothing writes: call a method that computes it first"});
    }
    SECTION("it is written later in the loop") {
        facts.plan.start.pop_back();
        CHECK(foundWith(facts, {lines.normals}) ==
              Messages{"22 error pressure_relaxation.first_half reads normal of wall before "
                       "wall_normals has written it: call wall_normals earlier, or in start"});
    }
    SECTION("a value carried around the loop needs an initial one") {
        facts.bodies[0].initial = {"velocity", "mass", "density"};
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half reads density_rate of water before "
                       "pressure_relaxation.second_half has written it: call "
                       "pressure_relaxation.second_half earlier, or in start"});
    }
    SECTION("a write under every does not count") {
        facts.plan.start.pop_back();
        lines.normals.every = now_and_then;
        facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(), {lines.normals});
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half reads normal of wall, which "
                       "wall_normals writes only in some steps: call wall_normals in start too"});
        facts.plan.start.push_back(DamBreak().normals);
        CHECK(found(facts).empty());
    }
    SECTION("an accumulated field before its first accumulator") {
        std::swap(facts.plan.outermost.steps[1], facts.plan.outermost.steps[2]);
        CHECK(found(facts) ==
              Messages{"22 error pressure_relaxation.first_half reads external_acceleration of "
                       "water before gravity has written it: call gravity earlier, or in start"});
    }
    SECTION("by the estimate of a time step, and said only once") {
        facts.bodies[0].initial = {"mass", "density", "density_rate"};
        CHECK(found(facts) == Messages{"11 error advection_dt reads velocity of water, which "
                                       "pressure_relaxation.first_half only updates: call a "
                                       "method that computes it first"});
    }
    SECTION("by a line that acts now and then") {
        look(facts, read("water", "vorticity"));
        CHECK(found(facts) ==
              Messages{"41 error look reads vorticity of water, which nothing writes: call a "
                       "method that computes it first"});
    }
    SECTION("it is content with what the step has written") {
        append(facts, {line(14, "force", {write("water", "force")})});
        look(facts, read("water", "force"));
        CHECK(found(facts).empty());
    }
}

TEST_CASE("accumulated fields are zeroed before their first accumulator") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    Call viscosity = line(15, "viscosity", {add("water", "external_acceleration")});
    Call load = line(24, "load", {add("gate", "force"), add("water", "reaction")});
    facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin() + 2, {viscosity});
    Layer& acoustic = std::get<Layer>(facts.plan.outermost.steps[3].value);
    acoustic.steps.insert(acoustic.steps.begin() + 1, {load});

    const auto outer = zeroings(facts.plan.outermost);
    REQUIRE(outer.size() == 1);
    CHECK(outer[0].body == "water");
    CHECK(outer[0].field == "external_acceleration");
    CHECK(outer[0].before == 1);
    const auto inner = zeroings(acoustic);
    REQUIRE(inner.size() == 2);
    CHECK(inner[0].body == "gate");
    CHECK(inner[0].field == "force");
    CHECK(inner[0].before == 1);
    CHECK(inner[1].field == "reaction");
    CHECK(inner[1].before == 1);
}

TEST_CASE("accumulated fields that spoil each other") {
    DamBreak lines;
    LoopFacts facts = lines.facts();
    Layer& acoustic = std::get<Layer>(facts.plan.outermost.steps[2].value);
    const Call viscosity = line(24, "viscosity", {add("water", "external_acceleration")});

    SECTION("in a layer and in one inside it") {
        acoustic.steps.insert(acoustic.steps.begin(), {viscosity});
        CHECK(found(facts) ==
              Messages{"24 error viscosity adds to external_acceleration of water in layer "
                       "acoustic, which zeroes it and so loses what gravity added in layer "
                       "advection: call both in the same layer",
                       "13 warning gravity adds to external_acceleration of water, but nothing "
                       "reads it before layer acoustic zeroes it again"});
    }
    SECTION("added after the last reader") {
        CHECK(foundWith(facts, {viscosity}) ==
              Messages{"24 warning viscosity adds to external_acceleration of water, but nothing "
                       "reads it before layer advection zeroes it again"});
    }
    SECTION("never read") {
        append(facts, {line(24, "load", {add("gate", "force")})});
        CHECK(found(facts) ==
              Messages{"24 warning load adds to force of gate, but nothing reads it before layer "
                       "advection zeroes it again"});
        look(facts, read("gate", "force"));
        CHECK(found(facts).empty());
    }
    SECTION("under every") {
        Call kick = viscosity;
        kick.every = now_and_then;
        facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin() + 2, {kick});
        CHECK(found(facts) == Messages{"24 warning viscosity adds to external_acceleration of "
                                       "water only in some steps, while its layer zeroes it in "
                                       "all of them"});
    }
    SECTION("set and accumulated") {
        const Call set = line(24, "wave", {write("water", "external_acceleration")});
        facts.plan.outermost.steps.insert(facts.plan.outermost.steps.begin(), {set});
        CHECK(found(facts) ==
              Messages{"24 error wave sets external_acceleration of water, which gravity adds to "
                       "and its layer zeroes: only one way of writing a field can be used"});
    }
    SECTION("in two layers side by side") {
        acoustic.steps.insert(acoustic.steps.begin(), {viscosity});
        Layer beside{"beside", {}, 1.0, Fit::split, {{viscosity}, {lines.first_half}}, 50};
        facts.plan.outermost.steps[1] = {beside};
        append(facts, {lines.neighbors});
        CHECK(found(facts).empty());
    }
}
