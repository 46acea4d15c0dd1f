// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/known_load.h"
#include "dynamics/register.h"
#include "entry.h"

#include <memory>
#include <string>

namespace sphinx::test {

/// An entry of `dynamics`, without the braces around it.
template <int Dim>
input::Component readMethod(const std::string& yaml) {
    static input::Registry all;
    if (all.names(input::Kind::dynamics).empty()) dynamics::registerDynamics(all);
    return readEntry("{" + yaml + "}", input::Kind::dynamics, all, Dim);
}

/// A method, which is called by its actions.
template <int Dim>
class MadeMethod {
 public:
    /// yaml: "type: force.gravity, body: block, acceleration: [0, -10]"
    MadeMethod(dynamics::Context<Dim>& context, const std::string& yaml)
        : entry_(readMethod<Dim>(yaml)),
          method_(entry_.declaration->builder<dynamics::MethodBuilder>().factory.make(
              entry_.parameters.get(), context)) {}

    /// Without a name the only action.
    void run(const Clock& clock, const std::string& action = "") const {
        const input::Declaration& declaration = *entry_.declaration;
        const auto index = static_cast<std::size_t>(declaration.actionIndex(action));
        const auto& bound = declaration.actions()[index].payload<dynamics::BoundAction>();
        bound.call<Dim>()(*method_, clock);
    }
    dynamics::Method* get() const { return method_.get(); }
    dynamics::Method* operator->() const { return method_.get(); }
    /// What it is besides: dynamics::AppliedLoad<2>, dynamics::fluid::SolidLoad<2>.
    template <class T>
    const T& as() const {
        return dynamic_cast<const T&>(*method_);
    }
    dynamics::Load<Dim> load() const { return as<dynamics::KnownLoad<Dim>>().load(); }

 private:
    input::Component entry_;
    std::unique_ptr<dynamics::Method> method_;
};

template <int Dim>
std::unique_ptr<dynamics::TimeStepMethod> makeTimeStep(dynamics::Context<Dim>& context,
                                                       const std::string& yaml) {
    const input::Component entry = readMethod<Dim>(yaml);
    return entry.declaration->builder<dynamics::Factory<dynamics::TimeStepMethod>>().make(
        entry.parameters.get(), context);
}

}  // namespace sphinx::test
