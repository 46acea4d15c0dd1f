// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/loop.h"

#include "bodies/shares.h"
#include "loop/flow/zeroing.h"

#include <algorithm>
#include <cassert>

namespace sphinx::build {
namespace {

/// Sets an accumulated field to zero before its first accumulator adds to it.
template <int Dim>
class ZeroField final : public dynamics::Method {
 public:
    ZeroField(bodies::Body<Dim>& body, particles::FieldBase& field) : body_(body), field_(field) {}
    void run(const Clock&) { field_.setZero(); }
    std::size_t workSize() const override { return body_.size(); }

 private:
    bodies::Body<Dim>& body_;
    particles::FieldBase& field_;
};

template <int Dim>
void bind(loop::Call& call, const model::Case& model, const Methods<Dim>& methods) {
    const auto [name, action] = model::splitAction(call.label);
    const input::Declaration& declaration = *model.findMethod(name)->declaration;
    call.method = methods.method(name);
    call.action = declaration.actions()[declaration.actionIndex(action)]
                      .payload<dynamics::BoundAction>()
                      .template call<Dim>();
}

/// A line of the loop's own, before the first that adds to the field.
template <int Dim>
loop::Call zeroing(const loop::Zeroing& zero, bodies::World<Dim>& world, Methods<Dim>& methods) {
    const auto run = [](dynamics::Method& method, const Clock& clock) {
        static_cast<ZeroField<Dim>&>(method).run(clock);
    };
    return {{"zero " + zero.field + " of " + zero.body},
            methods.zero(*world.find(zero.body), zero.field),
            run};
}

template <int Dim>
void bind(loop::Layer& layer, const model::Case& model, bodies::World<Dim>& world,
          Methods<Dim>& methods) {
    for (loop::TimeStep& estimate : layer.dt) estimate.method = methods.timeStep(estimate.label);
    for (loop::Step& step : layer.steps)
        if (auto* inner = std::get_if<loop::Layer>(&step.value))
            bind(*inner, model, world, methods);
        else
            bind(std::get<loop::Call>(step.value), model, methods);
    const std::vector<loop::Zeroing> zeroings = loop::zeroings(layer);
    for (auto zero = zeroings.rbegin(); zero != zeroings.rend(); ++zero)
        layer.steps.insert(layer.steps.begin() + static_cast<std::ptrdiff_t>(zero->before),
                           {zeroing(*zero, world, methods)});
}

}  // namespace

template <int Dim>
Methods<Dim>::Methods(const model::Case& model, dynamics::Context<Dim>& context)
    : world_(&context.world) {
    for (const input::Component& c : model.dynamics) {
        if (!model.calls(c.name)) continue;
        const void* parameters = c.parameters.get();
        if (c.declaration->isTimeStep())
            time_steps_[c.name] =
                c.declaration->builder<dynamics::Factory<dynamics::TimeStepMethod>>().make(
                    parameters, context);
        else
            methods_.emplace_back(
                c.name, c.declaration->builder<dynamics::MethodBuilder>().factory.make(parameters,
                                                                                       context));
    }
    for (const auto& [name, method] : methods_) method->announce();
}

template <int Dim>
void Methods<Dim>::prepare() {
    for (auto& body : world_->bodies)
        if (body->isElastic()) bodies::findShares(*body);
    for (const auto& [name, method] : methods_) method->prepare();
}

template <int Dim>
dynamics::Method* Methods<Dim>::method(std::string_view name) const {
    const auto found = std::ranges::find(methods_, name, &Named::first);
    assert(found != methods_.end());
    return found->second.get();
}

template <int Dim>
dynamics::Method* Methods<Dim>::zero(bodies::Body<Dim>& body, const std::string& field) {
    particles::FieldBase& values = body.particles.require(*fields::find(field));
    zeros_.push_back(std::make_unique<ZeroField<Dim>>(body, values));
    return zeros_.back().get();
}

template <int Dim>
std::vector<const dynamics::Method*> Methods<Dim>::all() const {
    std::vector<const dynamics::Method*> methods;
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
loop::Plan bindPlan(loop::Plan plan, const model::Case& model, bodies::World<Dim>& world,
                    Methods<Dim>& methods) {
    for (loop::Call& call : plan.start) bind(call, model, methods);
    bind(plan.outermost, model, world, methods);
    return plan;
}

template class Methods<2>;
template class Methods<3>;
template loop::Plan bindPlan(loop::Plan, const model::Case&, bodies::World<2>&, Methods<2>&);
template loop::Plan bindPlan(loop::Plan, const model::Case&, bodies::World<3>&, Methods<3>&);

}  // namespace sphinx::build
