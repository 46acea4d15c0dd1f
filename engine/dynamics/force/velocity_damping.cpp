// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"

#include <cmath>

namespace sphinx::dynamics::force {
namespace {

/// Drag in proportion to mass and velocity, dv/dt = -rate v, by its solution over the substep of
/// its layer, v *= exp(-rate dt): stable at any step. It brings a body to rest where the final
/// state, not the way to it, is asked for; a mode of the frequency omega is damped fastest at rate
/// = 2 omega.
struct VelocityDampingParameters {
    input::Name body;
    double rate = 0;  ///< 1/time
};

}  // namespace

void declareVelocityDamping(input::Registry& registry) {
    using P = VelocityDampingParameters;
    auto& d = declareBodyMethod<P>(registry, "force.velocity_damping",
                                   []<int Dim>(const P& p, Body<Dim>& body, Context<Dim>&) {
                                       auto& velocity = body.particles.vector(fields::velocity);
                                       return [&, rate = p.rate](const Clock& clock) {
                                           const double left = std::exp(-rate * clock.dt);
                                           parallelFor(body.size(),
                                                       [&](std::size_t i) { velocity[i] *= left; });
                                       };
                                   });
    d.summary("Drag in proportion to mass and velocity, which brings a body to rest");
    d.formula("dv_i/dt = -rate v_i, by v_i *= exp(-rate dt)");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.required("rate", &P::rate, input::number(unit::frequency).above(0),
               "part of the velocity that is lost per time");
    d.action().reads("body", {"velocity"}).writes("body", {"velocity"});
}

}  // namespace sphinx::dynamics::force
