// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/average_kinematics.h"

#include "core/parallel.h"

namespace sphinx::fsi {

template <int Dim>
AverageKinematics<Dim>::AverageKinematics(Body<Dim>& body)
    : body_(&body),
      position_(body.particles.position()),
      velocity_(body.particles.vector(fields::velocity)),
      average_velocity_(body.particles.vector(fields::average_velocity)),
      average_acceleration_(body.particles.vector(fields::average_acceleration)) {}

template <int Dim>
void AverageKinematics<Dim>::run(int action, const Clock& clock) {
    const std::size_t n = body_->size();
    if (action == 0) {
        old_position_.assign(position_.data(), position_.data() + n);
        old_velocity_.assign(velocity_.data(), velocity_.data() + n);
        return;
    }
    const double rate = 1 / clock.dt;
    parallelFor(n, [&](std::size_t i) {
        average_velocity_[i] = rate * (position_[i] - old_position_[i]);
        average_acceleration_[i] = rate * (velocity_[i] - old_velocity_[i]);
    });
}

void declareAverageKinematics(input::Registry& registry) {
    using P = AverageKinematicsParameters;
    auto& d = registry.declare<P>(input::Kind::dynamics, "fsi.average_kinematics");
    d.summary("Velocity and acceleration of an elastic body, averaged over a step of its fluid");
    d.formula("guide 2.2.4: average v = (r(t + dt) - r(t))/dt, average a = (v(t + dt) - v(t))/dt");
    d.citation("Zhang, Rezavand & Hu 2021, doi:10.1016/j.jcp.2020.110028");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.action("begin", "before the steps of the solid").reads("body", {"position", "velocity"});
    d.action("end", "after them, in the same layer")
        .reads("body", {"position", "velocity"})
        .writes("body", {"average_velocity", "average_acceleration"});
    d.builder(factory<Method, P>([]<int Dim>(const P& p, Context<Dim>& context) {
        return std::make_unique<AverageKinematics<Dim>>(bodyOf(context, p.body));
    }));
}

template class AverageKinematics<2>;
template class AverageKinematics<3>;

}  // namespace sphinx::fsi
