// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/sum_all.h"
#include "dynamics/methods.h"
#include "dynamics/part_method.h"
#include "input/expressions/vector_at_time.h"

namespace sphinx::dynamics::force {
namespace {

/// One force on a part of an elastic body, shared by its particles as their masses are, so that
/// each gets the acceleration F/M and the sum is exactly F. Evaluated at the middle of the step,
/// where the velocity gets its kick.
struct PointForceParameters {
    input::Name part;
    std::vector<input::FieldExpression> force;
};

}  // namespace

void declarePointForce(input::Registry& registry) {
    using P = PointForceParameters;
    auto& d = declarePartMethod<AppliedLoad, P>(
        registry, "force.point_force",
        []<int Dim>(const P& p, const Part<Dim>& whole, Context<Dim>&) {
            ParticleSet<Dim>& particles = whole.body().particles;
            const auto& velocity = particles.vector(fields::velocity);
            const auto& mass = particles.scalar(fields::mass);
            auto& external = particles.vector(fields::external_acceleration);
            return [&, given = p.force](const Clock& clock, KnownLoad<Dim>& known) {
                const Part<Dim>& part = known.part();
                const double half = 0.5 * clock.dt;
                const auto& position = particles.position();
                const double total = part.mass();
                const Vec<Dim> moment = sumAll(part.size(), [&](std::size_t n) -> Vec<Dim> {
                    const std::size_t i = part[n];
                    return mass[i] * (position[i] + half * velocity[i]);
                });
                const Vec<Dim> centre = moment / total;
                const Vec<Dim> force = input::VectorAtTime<Dim>(given, clock.time + half)(centre);
                const Vec<Dim> acceleration = force / total;
                parallelFor(part.size(), [&](std::size_t n) { external[part[n]] += acceleration; });
                Load<Dim> load;
                load.add(centre, force);
                known.setLoad(load);
            };
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

}  // namespace sphinx::dynamics::force
