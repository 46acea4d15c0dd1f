// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dam_break_facts.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

/// The dam break whose halves are a step.
struct Stepped : DamBreak {
    Call sort_now = sort;

    Stepped() {
        first_half.accesses.push_back({input::AccessMode::open, "water", "step"});
        second_half.accesses.push_back({input::AccessMode::close, "water", "step"});
        sort_now.every = {};
    }
    Messages with(std::vector<Step> acoustic_steps) const {
        LoopFacts all = facts();
        std::get<Layer>(all.plan.outermost.steps[2].value).steps = std::move(acoustic_steps);
        return found(all);
    }
};

}  // namespace

TEST_CASE("particles keep their places in memory from one half of a step to the other") {
    Stepped lines;
    CHECK(lines.with({{lines.first_half}, {lines.second_half}}).empty());
    const auto within = [](const std::string& line, int id) {
        return Messages{
            std::to_string(id) + " error " + line +
            " may reorder or remove particles of water within a step of it, whose end has to find "
            "them as they were: it belongs after pressure_relaxation.second_half"};
    };
    SECTION("a sort between them, with all lists built anew") {
        CHECK(lines.with(
                  {{lines.first_half}, {lines.sort_now}, {lines.neighbors}, {lines.second_half}}) ==
              within("sort", 31));
        lines.sort_now.every = now_and_then;
        CHECK(lines.with(
                  {{lines.first_half}, {lines.sort_now}, {lines.neighbors}, {lines.second_half}}) ==
              within("sort", 31));
        CHECK(
            lines
                .with(
                    {{lines.first_half}, {lines.second_half}, {lines.sort_now}, {lines.neighbors}})
                .empty());
    }
    SECTION("lists built anew between them, which may remove particles or not") {
        CHECK(lines.with({{lines.first_half}, {lines.neighbors}, {lines.second_half}}).empty());
        lines.neighbors.permutes = {"water"};
        CHECK(lines.with({{lines.first_half}, {lines.neighbors}, {lines.second_half}}) ==
              within("neighbors", 32));
        CHECK(lines.with({{lines.first_half}, {lines.second_half}}).empty());
    }
    SECTION("another body") {
        lines.sort_now.permutes = {"oil"};
        CHECK(lines.with({{lines.first_half}, {lines.sort_now}, {lines.second_half}}).empty());
    }
}

TEST_CASE("lists that are built anew where particles are removed are fresh") {
    DamBreak lines;
    lines.neighbors.permutes = {"water"};
    CHECK(found(lines.facts()).empty());
    lines.neighbors.every = now_and_then;  // then they are stale, but not invalid
    LoopFacts all = lines.facts();
    all.plan.outermost.steps = {{lines.gravity}, {lines.acoustic()}, {lines.neighbors}};
    const Messages messages = found(all);
    REQUIRE(messages.size() == 1);
    CHECK(messages[0].find("invalid") == std::string::npos);
}
