// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "dynamics/declare.h"
#include "loop/plan/plan.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sphinx::build {

/// What the methods of a case are built from. It refers to the case.
template <int Dim>
dynamics::Context<Dim> makeContext(const model::Case& model, bodies::World<Dim>& world,
                                   neighbors::Relations<Dim>& relations) {
    dynamics::Context<Dim> context{world, relations};
    if (model.multibody) context.multibody = &*model.multibody;
    context.start_time = model.loop.start_time;
    return context;
}

/// The methods that the loop of a case calls, made from their parameters, and the calls that zero
/// accumulated fields. What the loop does not call is not made: it cannot act.
template <int Dim>
class Methods {
 public:
    /// Has all of them announce.
    Methods(const model::Case& model, dynamics::Context<Dim>& context);

    /// Once, when the particles are there.
    void prepare();

    dynamics::Method* method(std::string_view name) const;
    dynamics::TimeStepMethod* timeStep(const std::string& name) const {
        return time_steps_.at(name).get();
    }
    /// A method that sets a field to zero; it lives as long as this object.
    dynamics::Method* zero(bodies::Body<Dim>& body, const std::string& field);

    std::vector<const dynamics::Method*> all() const;

    /// State of all methods, a section for each.
    void transfer(Archive& archive);

 private:
    bodies::World<Dim>* world_;
    using Named = std::pair<std::string, std::unique_ptr<dynamics::Method>>;
    std::vector<Named> methods_;  // in the order of the case
    std::map<std::string, std::unique_ptr<dynamics::TimeStepMethod>> time_steps_;
    std::vector<std::unique_ptr<dynamics::Method>> zeros_;
};

/// The plan that loopFacts() describes, ready to run but for its outputs: each line with its
/// method, and lines that zero what others accumulate.
template <int Dim>
loop::Plan bindPlan(loop::Plan described, const model::Case& model, bodies::World<Dim>& world,
                    Methods<Dim>& methods);

}  // namespace sphinx::build
