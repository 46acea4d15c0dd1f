// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/context.h"
#include "dynamics/dynamics.h"
#include "dynamics/rules.h"
#include "input/declaration/declaration.h"
#include "input/declaration/registry.h"

#include <memory>
#include <type_traits>

namespace sphinx::dynamics {

/// Makes a component in both dimensions.
template <class Product>
struct Factory {
    std::unique_ptr<Product> (*in2d)(const void* parameters, Context<2>&);
    std::unique_ptr<Product> (*in3d)(const void* parameters, Context<3>&);

    template <int Dim>
    std::unique_ptr<Product> make(const void* parameters, Context<Dim>& context) const {
        if constexpr (Dim == 2)
            return in2d(parameters, context);
        else
            return in3d(parameters, context);
    }
};

/// Make: a lambda without captures, []<int Dim>(const P&, Context<Dim>&), that returns a
/// std::unique_ptr to a class that derives from Product.
template <class Product, class P, class Make>
Factory<Product> factory(Make) {
    return {[](const void* p, Context<2>& context) -> std::unique_ptr<Product> {
                return Make{}.template operator()<2>(*static_cast<const P*>(p), context);
            },
            [](const void* p, Context<3>& context) -> std::unique_ptr<Product> {
                return Make{}.template operator()<3>(*static_cast<const P*>(p), context);
            }};
}

/// Makes components of a class template M with a constructor (Context<Dim>&, const P&).
template <template <int> class M, class P>
struct Construct {
    template <int Dim>
    std::unique_ptr<M<Dim>> operator()(const P& p, Context<Dim>& context) const {
        return std::make_unique<M<Dim>>(context, p);
    }
};

/// What Declaration::builder of a method holds; that of a time step is a Factory<TimeStepMethod>.
struct MethodBuilder {
    Factory<Method> factory;
    std::vector<Rule> rules;
    std::vector<WorldRule> world_rules;
    std::vector<CaseRule> case_rules;
};

/// What Action::payload of a method holds: its member functions for both dimensions.
struct BoundAction {
    ActionCall in2d;
    ActionCall in3d;

    template <int Dim>
    ActionCall call() const {
        return Dim == 2 ? in2d : in3d;
    }
};

/// Declaration of a method with the parameter struct P. Each action is bound to what it calls.
template <class P, class Make>
class DeclaredMethod final : public input::Declared<P> {
 public:
    DeclaredMethod(std::string name, Make make)
        : input::Declared<P>(input::Kind::dynamics, std::move(name)) {
        this->builder(MethodBuilder{factory<Method, P>(make), {}, {}, {}});
    }

    /// The only action of its method: run(const Clock&). Loop lines call it by the method's name.
    input::Action& action(std::string doc = {}) {
        return action("", std::move(doc),
                      [](auto& method, const Clock& clock) { method.run(clock); });
    }
    /// One of several, which loop lines call as METHOD.NAME. Call: a lambda without captures,
    /// [](auto& method, const Clock&).
    template <class Call>
    input::Action& action(std::string name, std::string doc, Call) {
        input::Action& added = this->addAction(std::move(name), std::move(doc));
        added.payload(BoundAction{&callOn<2, Call>, &callOn<3, Call>});
        return added;
    }

    /// Of the case as it is written: asked once it is read without errors. method.as<P>() are the
    /// parameters, method.placeOf("...") is where one of them stands.
    DeclaredMethod& rule(Rule check) {
        rules().rules.push_back(check);
        return *this;
    }
    /// With the particles at the start, before anything runs. Check: a lambda without captures,
    /// [](const input::Component& method, auto& built) with a BuiltCase<Dim>.
    template <class Check>
    DeclaredMethod& worldRule(Check) {
        rules().world_rules.push_back(
            {[](const input::Component& method, BuiltCase<2>& built) { Check{}(method, built); },
             [](const input::Component& method, BuiltCase<3>& built) { Check{}(method, built); }});
        return *this;
    }
    /// The same about the whole case, once, also when it has no method of this declaration. Check:
    /// [](auto& built).
    template <class Check>
    DeclaredMethod& caseRule(Check) {
        rules().case_rules.push_back({[](BuiltCase<2>& built) { Check{}(built); },
                                      [](BuiltCase<3>& built) { Check{}(built); }});
        return *this;
    }

 private:
    MethodBuilder& rules() { return std::any_cast<MethodBuilder&>(this->builder_); }

    template <int Dim>
    using Made = typename std::invoke_result_t<decltype(&Make::template operator()<Dim>), Make,
                                               const P&, Context<Dim>&>::element_type;

    template <int Dim, class Call>
    static void callOn(Method& method, const Clock& clock) {
        Call{}(static_cast<Made<Dim>&>(method), clock);
    }
};

/// Registers a method in both dimensions; make: see factory().
template <class P, class Make>
DeclaredMethod<P, Make>& declareMethod(input::Registry& registry, std::string name, Make make) {
    return registry.add(std::make_unique<DeclaredMethod<P, Make>>(std::move(name), make));
}

/// The same of a class template M with a constructor (Context<Dim>&, const P&).
template <template <int> class M, class P>
auto& declareMethod(input::Registry& registry, std::string name) {
    return declareMethod<P>(registry, std::move(name), Construct<M, P>{});
}

/// The body of a checked reference.
template <int Dim>
Body<Dim>& bodyOf(Context<Dim>& context, const input::Name& name) {
    return *context.world.find(name.text);
}

/// Parameters of a method that needs to know its body alone.
struct BodyParameters {
    input::Name body;
};

/// A method of one body that is no more than what its action does.
template <int Dim, class Run>
class BodyMethod final : public Method {
 public:
    BodyMethod(const Body<Dim>& body, Run run) : body_(&body), run_(std::move(run)) {}
    void run(const Clock& clock) { run_(clock); }
    std::size_t workSize() const override { return body_->size(); }

 private:
    const Body<Dim>* body_;
    Run run_;
};

/// Registers one with the parameter `body`; make: []<int Dim>(const P&, Body<Dim>&, Context<Dim>&),
/// which returns what the action does, [](const Clock&).
template <class P, class Make>
auto& declareBodyMethod(input::Registry& registry, std::string name, Make) {
    const auto method = []<int Dim>(const P& p, Context<Dim>& context) {
        Body<Dim>& body = bodyOf(context, p.body);
        auto run = Make{}(p, body, context);
        return std::make_unique<BodyMethod<Dim, decltype(run)>>(body, std::move(run));
    };
    return declareMethod<P>(registry, std::move(name), method);
}

/// The estimate of a time step for one body.
template <int Dim, class Estimate>
class BodyTimeStep final : public TimeStepMethod {
 public:
    BodyTimeStep(const Body<Dim>& body, Estimate estimate)
        : body_(&body), estimate_(std::move(estimate)) {}
    double estimate() override { return estimate_(); }
    std::size_t workSize() const override { return body_->size(); }

 private:
    const Body<Dim>* body_;
    Estimate estimate_;
};

/// Registers one, which a layer's `dt` names; make: []<int Dim>(const P&, Body<Dim>&), which
/// returns the estimate, []() -> double. What it reads is declared by timeStep().
template <class P, class Make>
input::Declared<P>& declareTimeStep(input::Registry& registry, std::string name, Make) {
    const auto method = []<int Dim>(const P& p, Context<Dim>& context) {
        Body<Dim>& body = bodyOf(context, p.body);
        auto estimate = Make{}(p, body);
        return std::make_unique<BodyTimeStep<Dim, decltype(estimate)>>(body, std::move(estimate));
    };
    return registry.declare<P>(input::Kind::dynamics, std::move(name))
        .builder(factory<TimeStepMethod, P>(method));
}

}  // namespace sphinx::dynamics
