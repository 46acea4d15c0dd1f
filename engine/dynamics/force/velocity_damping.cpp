// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/force/velocity_damping.h"

#include "core/parallel.h"

#include <cmath>

namespace sphinx::dynamics::force {

template <int Dim>
VelocityDamping<Dim>::VelocityDamping(Body<Dim>& body, double rate)
    : body_(&body), rate_(rate), velocity_(body.particles.vector(fields::velocity)) {}

template <int Dim>
void VelocityDamping<Dim>::run(const Clock& clock) {
    const double left = std::exp(-rate_ * clock.dt);
    parallelFor(body_->size(), [&](std::size_t i) { velocity_[i] *= left; });
}

void declareVelocityDamping(input::Registry& registry) {
    using P = VelocityDampingParameters;
    auto& d = declareMethod<P>(
        registry, "force.velocity_damping", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<VelocityDamping<Dim>>(bodyOf(context, p.body), p.rate);
        });
    d.summary("Drag in proportion to mass and velocity, which brings a body to rest");
    d.formula("dv_i/dt = -rate v_i, by v_i *= exp(-rate dt)");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.required("rate", &P::rate, input::number(unit::frequency).above(0),
               "part of the velocity that is lost per time");
    d.action().reads("body", {"velocity"}).writes("body", {"velocity"});
}

template class VelocityDamping<2>;
template class VelocityDamping<3>;

}  // namespace sphinx::dynamics::force
