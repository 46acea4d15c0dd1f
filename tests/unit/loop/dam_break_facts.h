// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/check.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sphinx::loop::fake {

inline dynamics::FieldAccess read(std::string body, std::string field) {
    return {input::AccessMode::read, std::move(body), std::move(field)};
}
inline dynamics::FieldAccess write(std::string body, std::string field) {
    return {input::AccessMode::write, std::move(body), std::move(field)};
}
inline dynamics::FieldAccess add(std::string body, std::string field) {
    return {input::AccessMode::accumulate, std::move(body), std::move(field)};
}

inline const Trigger now_and_then{Trigger::Kind::steps, 100, ""};

/// A line as its declaration describes it.
inline Call line(int id, std::string label, std::vector<dynamics::FieldAccess> accesses,
                 std::vector<std::string> permutes = {}, bool sometimes = false) {
    Call call{{std::move(label), id, std::move(accesses), std::move(permutes)}};
    if (sometimes) call.every = now_and_then;
    return call;
}
inline TimeStep estimate(int id, std::string label, std::vector<dynamics::FieldAccess> accesses) {
    return {{std::move(label), id, std::move(accesses)}};
}
inline Layer layer(int id, std::string name, std::vector<TimeStep> dt, std::vector<Step> steps,
                   Fit fit = Fit::split) {
    return {std::move(name), std::move(dt), {}, fit, std::move(steps), id};
}
inline Call limited(Call line, std::optional<double> from, std::optional<double> until) {
    line.window = {from, until};
    return line;
}

/// The declarations of a dam break, line by line; ids as in case files, top to bottom.
struct DamBreak {
    Call start_neighbors = line(1, "neighbors", {write("water", "neighbors")});
    Call normals = line(2, "wall_normals", {write("wall", "normal")});
    TimeStep advection_dt = estimate(11, "advection_dt", {read("water", "velocity")});
    Call density = line(12, "density_summation",
                        {read("water", "fresh_neighbors"), read("water", "mass"),
                         read("water", "density"), write("water", "density")});
    Call gravity = line(13, "gravity", {add("water", "external_acceleration")});
    TimeStep acoustic_dt = estimate(21, "acoustic_dt", {read("water", "velocity")});
    Call first_half =
        line(22, "pressure_relaxation.first_half",
             {read("water", "neighbors"), read("water", "density"), read("water", "density_rate"),
              read("water", "mass"), read("water", "external_acceleration"), read("wall", "normal"),
              read("water", "position"), read("water", "velocity"), write("water", "density"),
              write("water", "pressure"), write("water", "position"), write("water", "velocity")});
    Call second_half =
        line(23, "pressure_relaxation.second_half",
             {read("water", "neighbors"), read("water", "pressure"), read("water", "density"),
              read("water", "position"), read("water", "velocity"), write("water", "density_rate"),
              write("water", "density"), write("water", "position")});
    Call sort = line(31, "sort", {}, {"water"}, true);
    Call neighbors = line(32, "neighbors", {write("water", "neighbors")});

    Layer acoustic() const {
        return layer(20, "acoustic", {acoustic_dt}, {{first_half}, {second_half}});
    }
    LoopFacts facts() const {
        LoopFacts facts;
        facts.bodies = {
            {"water", true, {"velocity", "mass", "density", "density_rate", "pressure"}},
            {"wall", false, {"mass"}}};
        facts.lists = {{"water", "water", false}, {"water", "wall", false}};
        facts.plan.start = {start_neighbors, normals};
        facts.plan.outermost = layer(10, "advection", {advection_dt},
                                     {{density}, {gravity}, {acoustic()}, {sort}, {neighbors}});
        return facts;
    }
};

/// A last line of the loop, or a layer there.
inline void append(LoopFacts& facts, Step last) {
    facts.plan.outermost.steps.push_back(std::move(last));
}
/// One that only looks, now and then.
inline void look(LoopFacts& facts, dynamics::FieldAccess access) {
    append(facts, {line(41, "look", {std::move(access)}, {}, true)});
}

/// "id severity message" of each issue.
inline std::vector<std::string> found(const LoopFacts& facts) {
    std::vector<std::string> all;
    for (const Issue& issue : checkLoop(facts))
        all.push_back(std::to_string(issue.id) +
                      (issue.severity == Severity::error ? " error " : " warning ") +
                      issue.message);
    return all;
}

using Messages = std::vector<std::string>;

/// With one more line at the end.
inline Messages foundWith(LoopFacts facts, Step last) {
    append(facts, std::move(last));
    return found(facts);
}

}  // namespace sphinx::loop::fake
