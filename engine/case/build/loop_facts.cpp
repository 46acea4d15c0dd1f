// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/loop_facts.h"

#include "case/build/access.h"
#include "case/build/field_makers.h"
#include "case/build/initial_values.h"
#include "loop/flow/check.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::build {

std::optional<loop::Trigger> triggerOf(const input::Every& every) {
    using Kind = loop::Trigger::Kind;
    switch (every.by) {
        case input::Every::By::time: return loop::Trigger{Kind::time, every.time, ""};
        case input::Every::By::steps:
            return loop::Trigger{Kind::steps, static_cast<double>(every.steps), every.layer.text};
        case input::Every::By::wall_time:
            return loop::Trigger{Kind::wall_time, every.wall_seconds, ""};
        case input::Every::By::ends: break;
    }
    return {};
}

namespace {

class FactsMaker {
 public:
    explicit FactsMaker(const model::Case& model) : model_(model) {}

    PlacedFacts make() {
        loop::LoopFacts& facts = result_.facts;
        for (const model::Body& body : model_.bodies) {
            if (body.role == bodies::Role::observer) continue;
            const bool elastic = body.role == bodies::Role::elastic;
            // An elastic body may be held as a whole: the base of a gate.
            facts.bodies.push_back(
                {body.name, body.role == bodies::Role::fluid, initialFields(model_, body)});
            for (const model::Seen& seen : model_.seenBy(body.name)) {
                // Contact finds its pairs itself.
                if (seen.as == model::SeenAs::contact) continue;
                const bool own = seen.body.text == body.name;
                const bool bonded = seen.as == model::SeenAs::bonded;
                facts.lists.push_back({body.name, seen.body.text, bonded || (elastic && own)});
            }
        }
        facts.makers = fieldMakers(*model_.registry);
        facts.remedies.emplace(
            fields::external_acceleration.name,
            fmt::format("call a force.gravity first, with acceleration: {} where there is "
                        "no gravity",
                        model_.dimension == 2 ? "[0, 0]" : "[0, 0, 0]"));
        facts.time_unit = model_.units.suffix(unit::time);
        facts.plan.start_time = model_.loop.start_time;
        facts.plan.end_time = model_.loop.end_time;
        for (const model::Step& step : model_.loop.start) facts.plan.start.push_back(call(step));
        facts.plan.outermost = layer(model_.loop);
        return std::move(result_);
    }

 private:
    int id(const input::Place& place) {
        result_.places.push_back(place);
        return static_cast<int>(result_.places.size()) - 1;
    }

    /// Of the method's action of that name.
    loop::Line line(const input::Name& run) {
        const auto [name, action] = model::splitAction(run.text);
        const input::Component& method = *model_.findMethod(name);
        loop::Line line{run.text, id(run.place)};
        line.accesses = resolveAccesses(model_, method, method.declaration->actionIndex(action));
        const bool permutes = method.declaration->hasTrait("permutes");
        const bool removes = method.declaration->hasTrait("removes") &&
                             model_.domain.lost == bodies::LostParticles::remove;
        for (const dynamics::FieldAccess& access : line.accesses) {
            const bool fluid = model_.findBody(access.body)->role == bodies::Role::fluid;
            if ((permutes || (removes && fluid)) &&
                std::find(line.permutes.begin(), line.permutes.end(), access.body) ==
                    line.permutes.end())
                line.permutes.push_back(access.body);
        }
        return line;
    }

    loop::Call call(const model::Step& step) {
        loop::Call call{line(step.run)};
        call.every = step.every ? triggerOf(*step.every) : std::nullopt;
        call.window = step.window();
        return call;
    }

    loop::Layer layer(const model::Layer& source) {
        loop::Layer layer;
        layer.id = id(source.name.place);
        layer.name = source.name.text;
        layer.fit = source.fit;
        layer.fixed_dt = source.dt.number;
        for (const input::Name& name : source.dt.methods) layer.dt.push_back({line(name)});
        for (const model::Step& step : source.steps) {
            if (step.layer)
                layer.steps.push_back({this->layer(*step.layer)});
            else
                layer.steps.push_back({call(step)});
        }
        return layer;
    }

    const model::Case& model_;
    PlacedFacts result_;
};

}  // namespace

PlacedFacts loopFacts(const model::Case& model) { return FactsMaker(model).make(); }

void checkLoop(const PlacedFacts& placed, input::Diagnostics& diagnostics) {
    for (const loop::Issue& issue : loop::checkLoop(placed.facts)) {
        const input::Place& place = placed.places[static_cast<std::size_t>(issue.id)];
        if (issue.severity == loop::Severity::error)
            diagnostics.error(place, issue.message);
        else
            diagnostics.warning(place, issue.message);
    }
}

}  // namespace sphinx::build
