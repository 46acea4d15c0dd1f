// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/restart_fields.h"

#include "loop/flow/live_fields.h"
#include "particles/fields.h"

namespace sphinx::run {
namespace {

using FieldsOfBodies = std::map<std::string, std::set<std::string>>;

void collectWrites(const loop::Line& line, FieldsOfBodies& to) {
    for (const dynamics::FieldAccess& access : line.accesses)
        if (input::changes(access.mode)) to[access.body].insert(access.field);
}

void collectWrites(const loop::Layer& layer, FieldsOfBodies& always, FieldsOfBodies& sometimes) {
    for (const loop::Step& step : layer.steps) {
        if (const auto* line = std::get_if<loop::Call>(&step.value))
            collectWrites(*line, line->inEverySubstep() ? always : sometimes);
        else
            collectWrites(std::get<loop::Layer>(step.value), always, sometimes);
    }
}

}  // namespace

FieldsOfBodies restartFields(const loop::LoopFacts& facts) {
    FieldsOfBodies always, kept;
    collectWrites(facts.plan.outermost, always, kept);
    for (const loop::Line& line : facts.plan.start) collectWrites(line, kept);
    for (const loop::BodyFacts& body : facts.bodies)
        kept[body.name].insert(body.initial.begin(), body.initial.end());

    FieldsOfBodies result = loop::liveFields(facts);
    for (const auto& [body, names] : kept)
        for (const std::string& name : names)
            if (!always[body].contains(name)) result[body].insert(name);
    // Neighbor lists are written, too, but are no fields.
    for (auto& [body, names] : result)
        std::erase_if(names, [](const std::string& name) {
            return !fields::find(name) || name == fields::id.name || name == fields::position.name;
        });
    return result;
}

}  // namespace sphinx::run
