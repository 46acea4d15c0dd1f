// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/loop.h"

#include "bodies/shares.h"
#include "loop/flow/zeroing.h"

#include <algorithm>
#include <cassert>

namespace sphinx::model {
namespace {

/// Sets an accumulated field to zero before its first accumulator adds to it.
template <int Dim>
class ZeroField final : public Method {
 public:
    ZeroField(sphinx::Body<Dim>& body, FieldBase& field) : body_(body), field_(field) {}
    void run(const Clock&) { field_.setZero(); }
    std::size_t workSize() const override { return body_.size(); }

 private:
    sphinx::Body<Dim>& body_;
    FieldBase& field_;
};

template <int Dim>
loop::Call makeCall(const Case& model, const Step& step, const Methods<Dim>& methods) {
    const std::string label =
        step.action.empty() ? step.method.text : step.method.text + "." + step.action;
    const Component& component = *model.findMethod(step.method.text);
    const input::Action& action = component.declaration->actions()[step.action_index];
    return {label, methods.method(component.name),
            action.payload<BoundAction>().template call<Dim>(),
            step.every ? triggerOf(*step.every) : std::optional<loop::Trigger>{}, step.window};
}

template <int Dim>
loop::Layer makeLayer(const Case& model, const Layer& source, const loop::LayerFacts& facts,
                      World<Dim>& world, Methods<Dim>& methods) {
    loop::Layer layer;
    layer.name = source.name;
    for (const Name& name : source.dt_methods)
        layer.dt.push_back({name.text, methods.timeStep(name.text)});
    layer.fixed_dt = source.dt;
    layer.fit = source.fit;
    const std::vector<loop::Zeroing> zeroings = loop::zeroings(facts);
    std::size_t zeroed = 0;
    for (std::size_t k = 0; k < source.steps.size(); ++k) {
        for (; zeroed < zeroings.size() && zeroings[zeroed].before == k; ++zeroed) {
            const loop::Zeroing& z = zeroings[zeroed];
            const auto zero = [](Method& method, const Clock& clock) {
                static_cast<ZeroField<Dim>&>(method).run(clock);
            };
            layer.steps.push_back({loop::Call{"zero " + z.field + " of " + z.body,
                                              methods.zero(*world.find(z.body), z.field),
                                              zero,
                                              {},
                                              {}}});
        }
        const Step& step = source.steps[k];
        if (step.layer)
            layer.steps.push_back(
                {makeLayer(model, *step.layer, std::get<loop::LayerFacts>(facts.steps[k].value),
                           world, methods)});
        else
            layer.steps.push_back({makeCall(model, step, methods)});
    }
    return layer;
}

}  // namespace

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

template <int Dim>
Methods<Dim>::Methods(const Case& model, Context<Dim>& context) : world_(&context.world) {
    for (const Component& c : model.dynamics) {
        if (!model.calls(c.name)) continue;
        const void* parameters = c.parameters.get();
        if (c.declaration->isTimeStep())
            time_steps_[c.name] =
                c.declaration->builder<Factory<TimeStepMethod>>().make(parameters, context);
        else
            methods_.emplace_back(
                c.name, c.declaration->builder<MethodBuilder>().factory.make(parameters, context));
    }
    for (const auto& [name, method] : methods_) method->announce();
}

template <int Dim>
void Methods<Dim>::prepare() {
    for (const auto& body : world_->bodies)
        if (body->isElastic()) findShares(*body);
    for (const auto& [name, method] : methods_) method->prepare();
}

template <int Dim>
Method* Methods<Dim>::method(std::string_view name) const {
    const auto found = std::ranges::find(methods_, name, &Named::first);
    assert(found != methods_.end());
    return found->second.get();
}

template <int Dim>
Method* Methods<Dim>::zero(sphinx::Body<Dim>& body, const std::string& field) {
    FieldBase& values = body.particles.require(*fields::find(field));
    zeros_.push_back(std::make_unique<ZeroField<Dim>>(body, values));
    return zeros_.back().get();
}

template <int Dim>
std::vector<const Method*> Methods<Dim>::all() const {
    std::vector<const Method*> methods;
    for (const auto& [name, method] : methods_) methods.push_back(method.get());
    return methods;
}

template <int Dim>
void Methods<Dim>::transfer(Archive& archive) {
    for (const auto& [name, method] : methods_) {
        Section section(archive, name);
        method->transfer(archive);
    }
}

template <int Dim>
loop::Plan buildPlan(const Case& model, const loop::LoopFacts& facts, World<Dim>& world,
                     Methods<Dim>& methods) {
    loop::Plan plan;
    plan.start_time = model.loop.start_time;
    plan.end_time = model.loop.end_time;
    for (const Step& step : model.loop.start) plan.start.push_back(makeCall(model, step, methods));
    plan.outermost = makeLayer(model, model.loop.layer, facts.outermost, world, methods);
    return plan;
}

template class Methods<2>;
template class Methods<3>;
template loop::Plan buildPlan(const Case&, const loop::LoopFacts&, World<2>&, Methods<2>&);
template loop::Plan buildPlan(const Case&, const loop::LoopFacts&, World<3>&, Methods<3>&);

}  // namespace sphinx::model
