// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/force/spring.h"

#include "core/parallel.h"

namespace sphinx::dynamics::force {

template <int Dim>
Spring<Dim>::Spring(const Domain<Dim>& domain, Part<Dim> part, double stiffness, double damping)
    : AppliedLoad<Dim>(part),
      domain_(&domain),
      part_(part),
      stiffness_(stiffness),
      damping_(damping),
      initial_position_(part.body().particles.vector(fields::initial_position)),
      velocity_(part.body().particles.vector(fields::velocity)),
      external_(part.body().particles.vector(fields::external_acceleration)),
      mass_(part.body().particles.scalar(fields::mass)) {}

template <int Dim>
void Spring<Dim>::run(const Clock& clock) {
    const double half = 0.5 * clock.dt;
    const auto& position = part_.body().particles.position();
    AlignedVector<Vec<Dim>>& force = this->forces();
    const double share = 1 / (part_.mass() + damping_ * half);
    parallelFor(part_.size(), [&](std::size_t n) {
        const std::size_t i = part_[n];
        const Vec<Dim> u =
            domain_->difference(position[i], initial_position_[i]) + half * velocity_[i];
        const Vec<Dim> acceleration = share * (stiffness_ * u + damping_ * velocity_[i]);
        external_[i] -= acceleration;
        force[n] = -mass_[i] * acceleration;
    });
}

void declareSpring(input::Registry& registry) {
    using P = SpringParameters;
    auto& d =
        declareMethod<P>(registry, "force.spring", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<Spring<Dim>>(
                context.world.domain, Part<Dim>(context.world, p.part), p.stiffness, p.damping);
        });
    d.summary("Spring and dashpot from a part of an elastic body to where it was at the start");
    d.formula(
        "f_i = -m_i/M (k u_i + c v_i), M = sum_j m_j over the part, u_i = r_i - R_i; all "
        "together -k u - c v of the centre of mass");
    d.required("part", &P::part, input::partReference({"elastic"}), "body, or part of a body");
    d.required("stiffness", &P::stiffness, input::number(unit::force / unit::length).atLeast(0),
               "stiffness k of the whole part");
    d.optional("damping", &P::damping, input::number(unit::force / unit::velocity).atLeast(0),
               "damping c of the whole part");
    d.action("before the first half of the body's step, in the same layer")
        .reads("part", {"initial_position", "position", "velocity", "mass"})
        .accumulates("part", {"external_acceleration"});
}

template class Spring<2>;
template class Spring<3>;

}  // namespace sphinx::dynamics::force
