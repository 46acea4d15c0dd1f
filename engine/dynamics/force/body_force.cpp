// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/force/body_force.h"

#include "core/parallel.h"
#include "input/expressions/vector_at_time.h"

namespace sphinx::dynamics::force {

template <int Dim>
BodyForce<Dim>::BodyForce(Body<Dim>& body, std::vector<input::FieldExpression> acceleration)
    : body_(&body),
      acceleration_(std::move(acceleration)),
      external_(body.particles.vector(fields::external_acceleration)) {}

template <int Dim>
void BodyForce<Dim>::run(const Clock& clock) {
    const auto& position = body_->particles.position();
    const input::VectorAtTime<Dim> acceleration(acceleration_, clock.time);
    parallelFor(body_->size(), [&](std::size_t i) { external_[i] += acceleration(position[i]); });
}

void declareBodyForce(input::Registry& registry) {
    using P = BodyForceParameters;
    auto& d = declareMethod<P>(
        registry, "force.body_force", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<BodyForce<Dim>>(bodyOf(context, p.body), p.acceleration);
        });
    d.summary("Force per mass on a body, as expressions of place and time");
    d.formula("dv_i/dt += f(r_i, t)");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.required("acceleration", &P::acceleration, input::fieldVector(unit::acceleration),
               "force per mass, one expression of x, y, z, t for each direction");
    d.action().reads("body", {"position"}).accumulates("body", {"external_acceleration"});
}

template class BodyForce<2>;
template class BodyForce<3>;

}  // namespace sphinx::dynamics::force
