// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/force/point_force.h"

#include "core/sum_all.h"
#include "input/expressions/vector_at_time.h"

namespace sphinx::dynamics::force {

template <int Dim>
PointForce<Dim>::PointForce(Part<Dim> part, std::vector<input::FieldExpression> force)
    : AppliedLoad<Dim>(part),
      part_(part),
      force_(std::move(force)),
      velocity_(part.body().particles.vector(fields::velocity)),
      mass_(part.body().particles.scalar(fields::mass)),
      external_(part.body().particles.vector(fields::external_acceleration)) {}

template <int Dim>
void PointForce<Dim>::run(const Clock& clock) {
    const double half = 0.5 * clock.dt;
    const auto& position = part_.body().particles.position();
    const double mass = part_.mass();
    const Vec<Dim> moment = sumAll(part_.size(), [&](std::size_t n) -> Vec<Dim> {
        const std::size_t i = part_[n];
        return mass_[i] * (position[i] + half * velocity_[i]);
    });
    const Vec<Dim> centre = moment / mass;
    const Vec<Dim> force = input::VectorAtTime<Dim>(force_, clock.time + half)(centre);
    const Vec<Dim> acceleration = force / mass;
    parallelFor(part_.size(), [&](std::size_t n) { external_[part_[n]] += acceleration; });
    Load<Dim> load;
    load.add(centre, force);
    this->setLoad(load);
}

void declarePointForce(input::Registry& registry) {
    using P = PointForceParameters;
    auto& d = declareMethod<P>(
        registry, "force.point_force", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<PointForce<Dim>>(Part<Dim>(context.world, p.part), p.force);
        });
    d.summary(
        "One force on a part of an elastic body, shared by its particles as their masses are");
    d.formula("dv_i/dt += F(t + dt/2)/M, M = sum_j m_j over the part: the forces add up to F");
    d.required("part", &P::part, input::partReference({"elastic"}), "body, or part of a body");
    d.required("force", &P::force, input::fieldVector(unit::force),
               "force on the whole part, one expression of t for each direction; x, y, z are its "
               "centre of mass");
    d.action("before the first half of the body's step, in the same layer")
        .reads("part", {"position", "velocity", "mass"})
        .accumulates("part", {"external_acceleration"});
}

template class PointForce<2>;
template class PointForce<3>;

}  // namespace sphinx::dynamics::force
