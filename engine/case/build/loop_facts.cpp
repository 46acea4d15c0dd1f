// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/loop_facts.h"

#include "case/build/access.h"
#include "case/build/field_makers.h"
#include "case/build/initial_values.h"
#include "loop/flow/check.h"

#include <algorithm>

namespace sphinx::model {
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
        facts.start_time = model_.loop.start_time;
        facts.time_unit = model_.units.suffix(unit::time);
        for (const Step& step : model_.loop.start) facts.start.push_back(line(step));
        facts.outermost = layer(model_.loop.layer);
        return std::move(result_);
    }

 private:
    int id(const Place& place) {
        result_.places.push_back(place);
        return static_cast<int>(result_.places.size()) - 1;
    }

    loop::LineFacts line(const Step& step) {
        const Component& method = *model_.findMethod(step.method.text);
        loop::LineFacts facts;
        facts.id = id(step.place);
        facts.label = step.action.empty() ? method.name : method.name + "." + step.action;
        facts.accesses = resolveAccesses(model_, method, step.action_index);
        facts.sometimes = step.every.has_value();
        facts.window = step.window;
        const bool permutes = method.declaration->hasTrait("permutes");
        const bool removes =
            method.declaration->hasTrait("removes") && model_.domain.lost == LostParticles::remove;
        for (const FieldAccess& access : facts.accesses) {
            const bool fluid = model_.findBody(access.body)->role == Role::fluid;
            if ((permutes || (removes && fluid)) &&
                std::find(facts.permutes.begin(), facts.permutes.end(), access.body) ==
                    facts.permutes.end())
                facts.permutes.push_back(access.body);
        }
        return facts;
    }

    loop::LayerFacts layer(const Layer& source) {
        loop::LayerFacts facts;
        facts.id = id(source.place);
        facts.name = source.name;
        facts.fit = source.fit;
        facts.fixed_dt = source.dt.has_value();
        for (const Name& name : source.dt_methods) {
            loop::LineFacts estimate;
            estimate.id = id(name.place);
            estimate.label = name.text;
            estimate.accesses = resolveAccesses(model_, *model_.findMethod(name.text), 0);
            facts.dt.push_back(std::move(estimate));
        }
        for (const Step& step : source.steps) {
            if (step.layer)
                facts.steps.push_back({layer(*step.layer)});
            else
                facts.steps.push_back({line(step)});
        }
        return facts;
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
