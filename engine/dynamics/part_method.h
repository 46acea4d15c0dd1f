// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/known_load.h"

namespace sphinx::dynamics {

/// A method that acts on one part and knows its load, a Support or an AppliedLoad; once the window
/// of its line is over, there is none.
template <template <int> class Kind, int Dim>
class PartMethod : public Method, public Kind<Dim> {
 public:
    using Kind<Dim>::Kind;
    std::size_t workSize() const override { return this->part().size(); }
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }
};

/// One that is no more than what its action does.
template <template <int> class Kind, int Dim, class Run>
class RunPartMethod final : public PartMethod<Kind, Dim> {
 public:
    RunPartMethod(const Part<Dim>& part, Run run)
        : PartMethod<Kind, Dim>(part), run_(std::move(run)) {}
    void run(const Clock& clock) { run_(clock, *this); }

 private:
    Run run_;
};

/// Registers one with the parameter `part`; make: []<int Dim>(const P&, const Part<Dim>&,
/// Context<Dim>&), which returns what the action does, [](const Clock&, KnownLoad<Dim>&): it says
/// the load, and finds the part there.
template <template <int> class Kind, class P, class Make>
auto& declarePartMethod(input::Registry& registry, std::string name, Make) {
    const auto method = []<int Dim>(const P& p, Context<Dim>& context) {
        const Part<Dim> part(context.world, p.part);
        auto run = Make{}(p, part, context);
        return std::make_unique<RunPartMethod<Kind, Dim, decltype(run)>>(part, std::move(run));
    };
    return declareMethod<P>(registry, std::move(name), method);
}

}  // namespace sphinx::dynamics
