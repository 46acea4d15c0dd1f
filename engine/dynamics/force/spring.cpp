// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "dynamics/part_method.h"

namespace sphinx::dynamics::force {
namespace {

/// Springs and dashpots from the particles of a part to their initial positions, with the total
/// stiffness k and damping c shared as the masses are: f_i = -m_i/M (k u_i + c v_i). Their sum is
/// that of one spring and one dashpot at the centre of mass, whatever the deformation. Taken at the
/// middle of the step, where the velocity gets its kick dt a: u = r + dt/2 v - R and v + dt/2 a, so
/// that a (M + c dt/2) = -(k u + c v).
struct SpringParameters {
    input::Name part;
    double stiffness = 0;
    double damping = 0;
};

}  // namespace

void declareSpring(input::Registry& registry) {
    using P = SpringParameters;
    auto& d = declarePartMethod<AppliedLoad, P>(
        registry, "force.spring",
        []<int Dim>(const P& p, const Part<Dim>& whole, Context<Dim>& context) {
            ParticleSet<Dim>& particles = whole.body().particles;
            const auto& start = particles.vector(fields::initial_position);
            const auto& velocity = particles.vector(fields::velocity);
            const auto& mass = particles.scalar(fields::mass);
            auto& external = particles.vector(fields::external_acceleration);
            return
                [&, p, domain = &context.world.domain](const Clock& clock, KnownLoad<Dim>& load) {
                    const Part<Dim>& part = load.part();
                    const double half = 0.5 * clock.dt;
                    const auto& position = particles.position();
                    AlignedVector<Vec<Dim>>& force = load.forces();
                    const double share = 1 / (part.mass() + p.damping * half);
                    parallelFor(part.size(), [&](std::size_t n) {
                        const std::size_t i = part[n];
                        const Vec<Dim> u =
                            domain->difference(position[i], start[i]) + half * velocity[i];
                        const Vec<Dim> acceleration =
                            share * (p.stiffness * u + p.damping * velocity[i]);
                        external[i] -= acceleration;
                        force[n] = -mass[i] * acceleration;
                    });
                };
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

}  // namespace sphinx::dynamics::force
