// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/loop_facts.h"

#include "case/build/access.h"
#include "case/build/field_makers.h"
#include "case/build/initial_values.h"
#include "loop/flow/check.h"

#include <algorithm>

namespace sphinx::model {

std::optional<loop::Trigger> triggerOf(const Every& every) {
    using Kind = loop::Trigger::Kind;
    switch (every.by) {
        case Every::By::time: return loop::Trigger{Kind::time, every.time, ""};
        case Every::By::steps:
            return loop::Trigger{Kind::steps, static_cast<double>(every.steps), every.layer.text};
        case Every::By::wall_time: return loop::Trigger{Kind::wall_time, every.wall_seconds, ""};
        case Every::By::ends: break;
    }
    return {};
}

namespace {

class FactsMaker {
 public:
    explicit FactsMaker(const Case& model) : model_(model) {}

    PlacedFacts make() {
        loop::LoopFacts& facts = result_.facts;
        for (const Body& body : model_.bodies) {
            if (body.role == Role::observer) continue;
            const bool elastic = body.role == Role::elastic;
            // An elastic body may be held as a whole: the base of a gate.
            facts.bodies.push_back(
                {body.name, body.role == Role::fluid, initialFields(model_, body)});
            for (const Contact& contact : model_.seenBy(body.name)) {
                const bool own = contact.body.text == body.name;
                facts.lists.push_back(
                    {body.name, contact.body.text, contact.bonded || (elastic && own)});
            }
        }
        facts.makers = fieldMakers(*model_.registry);
        facts.time_unit = model_.units.suffix(unit::time);
        facts.plan.start_time = model_.loop.start_time;
        facts.plan.end_time = model_.loop.end_time;
        for (const Step& step : model_.loop.start) facts.plan.start.push_back(call(step));
        facts.plan.outermost = layer(model_.loop);
        return std::move(result_);
    }

 private:
    int id(const Place& place) {
        result_.places.push_back(place);
        return static_cast<int>(result_.places.size()) - 1;
    }

    /// Of the method's action of that name.
    loop::Line line(const Name& run) {
        const auto [name, action] = splitAction(run.text);
        const Component& method = *model_.findMethod(name);
        loop::Line line{run.text, id(run.place)};
        line.accesses = resolveAccesses(model_, method, method.declaration->actionIndex(action));
        const bool permutes = method.declaration->hasTrait("permutes");
        const bool removes =
            method.declaration->hasTrait("removes") && model_.domain.lost == LostParticles::remove;
        for (const FieldAccess& access : line.accesses) {
            const bool fluid = model_.findBody(access.body)->role == Role::fluid;
            if ((permutes || (removes && fluid)) &&
                std::find(line.permutes.begin(), line.permutes.end(), access.body) ==
                    line.permutes.end())
                line.permutes.push_back(access.body);
        }
        return line;
    }

    loop::Call call(const Step& step) {
        loop::Call call{line(step.run)};
        call.every = step.every ? triggerOf(*step.every) : std::nullopt;
        call.window = step.window();
        return call;
    }

    loop::Layer layer(const Layer& source) {
        loop::Layer layer;
        layer.id = id(source.name.place);
        layer.name = source.name.text;
        layer.fit = source.fit;
        layer.fixed_dt = source.dt.number;
        for (const Name& name : source.dt.methods) layer.dt.push_back({line(name)});
        for (const Step& step : source.steps) {
            if (step.layer)
                layer.steps.push_back({this->layer(*step.layer)});
            else
                layer.steps.push_back({call(step)});
        }
        return layer;
    }

    const Case& model_;
    PlacedFacts result_;
};

}  // namespace

PlacedFacts loopFacts(const Case& model) { return FactsMaker(model).make(); }

void checkLoop(const PlacedFacts& placed, input::Diagnostics& diagnostics) {
    for (const loop::Issue& issue : loop::checkLoop(placed.facts)) {
        const Place& place = placed.places[static_cast<std::size_t>(issue.id)];
        if (issue.severity == loop::Severity::error)
            diagnostics.error(place, issue.message);
        else
            diagnostics.warning(place, issue.message);
    }
}

}  // namespace sphinx::model
