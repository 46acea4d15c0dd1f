// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/force/gravity.h"

#include "core/parallel.h"

namespace sphinx::dynamics::force {

template <int Dim>
Gravity<Dim>::Gravity(Body<Dim>& body, const Vec<Dim>& acceleration)
    : body_(&body),
      acceleration_(acceleration),
      external_(body.particles.vector(fields::external_acceleration)) {}

template <int Dim>
void Gravity<Dim>::run(const Clock&) {
    parallelFor(body_->size(), [&](std::size_t i) { external_[i] += acceleration_; });
}

void declareGravity(input::Registry& registry) {
    using P = GravityParameters;
    auto& d =
        declareMethod<P>(registry, "force.gravity", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<Gravity<Dim>>(bodyOf(context, p.body),
                                                  p.acceleration.as<Dim>());
        });
    d.summary("Uniform gravity on a body");
    d.formula("dv_i/dt += g");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.required("acceleration", &P::acceleration, input::coordinates(unit::acceleration),
               "acceleration of free fall, a vector");
    d.action()
        .accumulates("body", {"external_acceleration"})
        .throughout(
            "the pressure of a fluid at rest and the potential energy count on it at all times; "
            "force.body_force can act at times");
}

template class Gravity<2>;
template class Gravity<3>;

}  // namespace sphinx::dynamics::force
