// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/new_particles.h"

#include "core/parallel.h"
#include "materials/fluid_laws.h"
#include "materials/holzapfel_muscle.h"

#include <cassert>

namespace sphinx::bodies {
namespace {

/// Calls give(particle, i) for all of them, i their places in the body.
template <int Dim, class Give>
void giveAll(const std::vector<NewParticle<Dim>>& made, std::size_t first, Give&& give) {
    parallelFor(made.size(), [&](std::size_t k) { give(made[k], first + k); });
}

template <int Dim>
void giveMass(Body<Dim>& body, const std::vector<NewParticle<Dim>>& made, std::size_t first) {
    particles::ParticleSet<Dim>& particles = body.particles;
    auto& velocity = particles.vector(fields::velocity);
    auto& density = particles.scalar(fields::density);
    auto& mass = particles.scalar(fields::mass);
    auto& volume = particles.scalar(fields::volume);
    const auto give = [&](auto&& densityOf) {
        giveAll(made, first, [&](const NewParticle<Dim>& one, std::size_t i) {
            velocity[i] = one.velocity;
            volume[i] = one.volume;
            density[i] = densityOf(one);
            mass[i] = density[i] * volume[i];
        });
    };
    if (!body.isFluid())
        return give([&](const NewParticle<Dim>&) { return body.material()->density(); });
    materials::withLaw(*body.fluid().material, [&](const auto& law) {
        give([&](const NewParticle<Dim>& one) { return law.densityAt(one.pressure); });
    });
    auto& pressure = particles.scalar(fields::pressure);
    giveAll(made, first,
            [&](const NewParticle<Dim>& one, std::size_t i) { pressure[i] = one.pressure; });
}

template <int Dim>
void giveFibres(const materials::HolzapfelMuscle& muscle, particles::ParticleSet<Dim>& particles,
                const std::vector<NewParticle<Dim>>& made, std::size_t first) {
    auto& fibre = particles.vector(fields::fibre);
    auto& sheet = particles.vector(fields::sheet);
    giveAll(made, first, [&](const NewParticle<Dim>& one, std::size_t i) {
        materials::Fibres<Dim> fibres;
        [[maybe_unused]] const auto violation =
            muscle.parameters().template directions<Dim>(one.position, fibres);
        assert(!violation && "the directions of the fibres were not looked at before");
        fibre[i] = fibres.fibre;
        sheet[i] = fibres.sheet;
    });
}

}  // namespace

std::vector<const particles::FieldInfo*> ownFields(Role role, bool fibres) {
    if (role == Role::observer) return {};
    std::vector<const particles::FieldInfo*> own{&fields::velocity, &fields::density, &fields::mass,
                                                 &fields::volume};
    own.push_back(role == Role::fluid ? &fields::pressure : &fields::acceleration);
    if (role == Role::elastic) own.push_back(&fields::initial_position);
    if (fibres) own.insert(own.end(), {&fields::fibre, &fields::sheet});
    return own;
}

template <int Dim>
void addParticles(Body<Dim>& body, const std::vector<NewParticle<Dim>>& made) {
    particles::ParticleSet<Dim>& particles = body.particles;
    const auto* muscle = dynamic_cast<const materials::HolzapfelMuscle*>(body.material());
    for (const particles::FieldInfo* field : ownFields(body.roleName(), muscle))
        particles.require(*field);
    particles.append(made.size(), [&](std::size_t first) {
        giveAll(made, first, [&](const NewParticle<Dim>& one, std::size_t i) {
            particles.position()[i] = one.position;
        });
        if (!body.isObserver()) giveMass(body, made, first);
        if (muscle) giveFibres(*muscle, particles, made, first);
    });
    ++body.version;
}

template void addParticles(Body<2>&, const std::vector<NewParticle<2>>&);
template void addParticles(Body<3>&, const std::vector<NewParticle<3>>&);

}  // namespace sphinx::bodies
