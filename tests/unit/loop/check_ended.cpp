// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dam_break_facts.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

/// The dam break with lines before all others.
struct Marked : DamBreak {
    const Call mark = line(14, "mark", {write("wall", "mark")});
    const Call look = line(15, "look", {read("wall", "mark")});

    Messages with(const std::vector<Step>& lines) const {
        LoopFacts all = facts();
        all.plan.outermost.steps.insert(all.plan.outermost.steps.begin(), lines.begin(),
                                        lines.end());
        return found(all);
    }
};

}  // namespace

TEST_CASE("what has ceased to be written is not read on") {
    const Marked lines;
    const Messages until_1{
        "15 error look reads mark of wall, which mark writes only at times until 1: it would keep "
        "its last value for ever; let look end with it, or something write it later"};
    CHECK(lines.with({{limited(lines.mark, {}, 1.0)}, {lines.look}}) == until_1);
    CHECK(lines.with({{limited(lines.mark, {}, 1.0)}, {limited(lines.look, 0.5, 3.0)}}) == until_1);
    CHECK(lines.with({{limited(lines.mark, {}, 1.0)}, {limited(lines.look, {}, 1.0)}}).empty());
    SECTION("a value from the start does not come back") {
        LoopFacts all = lines.facts();
        all.plan.start.push_back(lines.mark);
        all.plan.outermost.steps.insert(all.plan.outermost.steps.begin(),
                                        {{limited(lines.mark, {}, 1.0)}, {lines.look}});
        CHECK(found(all) == until_1);
    }
    SECTION("a pause is none, nor is another writer") {
        CHECK(
            lines
                .with(
                    {{limited(lines.mark, {}, 1.0)}, {limited(lines.mark, 2.0, {})}, {lines.look}})
                .empty());
        CHECK(lines
                  .with({{limited(lines.mark, {}, 1.0)},
                         {lines.look},
                         {line(16, "other", {write("wall", "mark")})}})
                  .empty());
    }
    SECTION("one message for what is read too early and too late") {
        CHECK(
            lines.with({{limited(lines.mark, 1.0, 1.1)}, {limited(lines.look, 2.0, {})}}).size() ==
            1);
    }
}

TEST_CASE("an inner layer looks at what the layer around it has ceased to write") {
    const Marked lines;
    LoopFacts all = lines.facts();
    all.plan.outermost.steps.insert(all.plan.outermost.steps.begin(),
                                    {limited(lines.mark, {}, 1.0)});
    auto& inner = std::get<Layer>(all.plan.outermost.steps[3].value).steps;
    inner.push_back({lines.look});
    CHECK(found(all).size() == 1);
    inner.back() = {limited(lines.look, {}, 1.0)};
    CHECK(found(all).empty());
}

TEST_CASE("what may stay as it is") {
    Marked lines;
    SECTION("a place where something stands still") {
        const Call push = line(14, "push", {read("wall", "position"), write("wall", "position")});
        const Call look = line(15, "look", {read("wall", "position")});
        Call update = lines.neighbors;
        CHECK(lines.with({{limited(push, {}, 1.0)}, {update}, {look}}).empty());
    }
    SECTION("what is zero when the window is over") {
        const Call push =
            line(14, "push",
                 {write("wall", "velocity"), {input::AccessMode::release, "wall", "velocity"}}, {},
                 false);
        const Call look = line(15, "look", {read("wall", "velocity")});
        CHECK(lines.with({{limited(push, {}, 1.0)}, {look}}).empty());
    }
    SECTION("what its layer zeroes") {
        const Call push = line(14, "push", {add("wall", "force")});
        const Call look = line(15, "look", {read("wall", "force")});
        CHECK(lines.with({{limited(push, {}, 1.0)}, {look}}).empty());
    }
    SECTION("the state of a fluid that stands still, for its time step") {
        LoopFacts all = lines.facts();
        std::get<Layer>(all.plan.outermost.steps[2].value).steps = {
            {limited(lines.first_half, {}, 1.0)}, {limited(lines.second_half, {}, 1.0)}};
        CHECK(found(all).empty());
    }
}
