// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/check.h"

#include <string>
#include <utility>
#include <vector>

namespace sphinx::loop::fake {

inline FieldAccess read(std::string body, std::string field) {
    return {AccessMode::read, std::move(body), std::move(field)};
}
inline FieldAccess write(std::string body, std::string field) {
    return {AccessMode::write, std::move(body), std::move(field)};
}
inline FieldAccess add(std::string body, std::string field) {
    return {AccessMode::accumulate, std::move(body), std::move(field)};
}

/// The declarations of a dam break, line by line; ids as in case files, top to bottom.
struct DamBreak {
    LineFacts start_neighbors{1, "neighbors", {write("water", "neighbors")}, {}, false};
    LineFacts normals{2, "wall_normals", {write("wall", "normal")}, {}, false};
    LineFacts advection_dt{11, "advection_dt", {read("water", "velocity")}, {}, false};
    LineFacts density{12,
                      "density_summation",
                      {read("water", "fresh_neighbors"), read("water", "mass"),
                       read("water", "density"), write("water", "density")},
                      {},
                      false};
    LineFacts gravity{13, "gravity", {add("water", "external_acceleration")}, {}, false};
    LineFacts acoustic_dt{21, "acoustic_dt", {read("water", "velocity")}, {}, false};
    LineFacts first_half{
        22,
        "pressure_relaxation.first_half",
        {read("water", "neighbors"), read("water", "density"), read("water", "density_rate"),
         read("water", "mass"), read("water", "external_acceleration"), read("wall", "normal"),
         read("water", "position"), read("water", "velocity"), write("water", "density"),
         write("water", "pressure"), write("water", "position"), write("water", "velocity")},
        {},
        false};
    LineFacts second_half{
        23,
        "pressure_relaxation.second_half",
        {read("water", "neighbors"), read("water", "pressure"), read("water", "density"),
         read("water", "position"), read("water", "velocity"), write("water", "density_rate"),
         write("water", "density"), write("water", "position")},
        {},
        false};
    LineFacts sort{31, "sort", {}, {"water"}, true};
    LineFacts neighbors{32, "neighbors", {write("water", "neighbors")}, {}, false};
    LineFacts fields{41, "fields", {read("water", "pressure"), read("wall", "normal")}, {}, true};

    LayerFacts acoustic() const {
        return {20, "acoustic", Fit::split, {acoustic_dt}, false, {{first_half}, {second_half}}};
    }
    LoopFacts facts() const {
        LoopFacts facts;
        facts.bodies = {
            {"water", true, {"velocity", "mass", "density", "density_rate", "pressure"}},
            {"wall", false, {"mass"}}};
        facts.lists = {{"water", "water", false}, {"water", "wall", false}};
        facts.start = {start_neighbors, normals};
        facts.outermost = {10,         "advection",
                           Fit::split, {advection_dt},
                           false,      {{density}, {gravity}, {acoustic()}, {sort}, {neighbors}}};
        facts.outputs = {fields};
        return facts;
    }
};

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

}  // namespace sphinx::loop::fake
