// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "input/expressions/vector_at_time.h"

namespace sphinx::dynamics::force {
namespace {

/// Force per mass given as expressions of place and time, evaluated at the middle of a substep of
/// its layer, where particles come to with their present velocity: at its start the impulse of a
/// force that changes would be off by a part of dt, not of dt^2.
struct BodyForceParameters {
    input::Name body;
    std::vector<input::FieldExpression> acceleration;
};

}  // namespace

void declareBodyForce(input::Registry& registry) {
    using P = BodyForceParameters;
    auto& d = declareBodyMethod<P>(
        registry, "force.body_force", []<int Dim>(const P& p, Body<Dim>& body, Context<Dim>&) {
            const auto& position = body.particles.position();
            const auto& velocity = body.particles.vector(fields::velocity);
            auto& external = body.particles.vector(fields::external_acceleration);
            return [&, given = p.acceleration](const Clock& clock) {
                const double half = clock.is_start ? 0 : 0.5 * clock.dt;
                const input::VectorAtTime<Dim> acceleration(given, clock.time + half);
                parallelFor(body.size(), [&](std::size_t i) {
                    external[i] += acceleration(position[i] + half * velocity[i]);
                });
            };
        });
    d.summary("Force per mass on a body, as expressions of place and time");
    d.formula("dv_i/dt += f(r_i + v_i dt/2, t + dt/2), the middle of the step of its layer");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.required("acceleration", &P::acceleration, input::fieldVector(unit::acceleration),
               "force per mass, one expression of x, y, z, t for each direction");
    d.action()
        .reads("body", {"position", "velocity"})
        .accumulates("body", {"external_acceleration"});
}

}  // namespace sphinx::dynamics::force
