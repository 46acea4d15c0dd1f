// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/clamp.h"

#include <fmt/format.h>

namespace sphinx::dynamics::constraint {

template <int Dim>
Clamp<Dim>::Clamp(Context<Dim>& context, Part<Dim> part)
    : Support<Dim>(part),
      relations_(&context.relations),
      part_(part),
      relation_(&context.relations.reference(part.body(), part.body())),
      position_(part.body().particles.position()),
      velocity_(part.body().particles.vector(fields::velocity)),
      acceleration_(part.body().particles.vector(fields::acceleration)),
      external_(part.body().particles.vector(fields::external_acceleration)),
      pressure_force_(part.body().particles.vector(fields::pressure_force)),
      viscous_force_(part.body().particles.vector(fields::viscous_force)),
      mass_(part.body().particles.scalar(fields::mass)) {}

template <int Dim>
void Clamp<Dim>::findImages() {
    const std::uint64_t arrangement = part_.body().particles.arrangement();
    if (arrangement == arrangement_) return;
    relations_->build(*relation_);
    images_ = part_.images();
    links_ = mirrorImages(part_, images_, *relation_, relations_->domain());
    arrangement_ = arrangement;
}

template <int Dim>
void Clamp<Dim>::run(const Clock& clock) {
    findImages();
    if (!clock.is_start) {
        const auto load = [&](Index i) -> Vec<Dim> {
            return mass_[i] * external_[i] + pressure_force_[i] + viscous_force_[i];
        };
        Load<Dim> reaction;
        for (const Index i : images_) reaction.add(position_[i], -mass_[i] * acceleration_[i]);
        for (const ImageLink& link : links_) {
            const Index i = link.image;
            const Vec<Dim> force = link.weight * (mass_[i] * acceleration_[i] - load(i));
            reaction.add(position_[link.real], force);
            acceleration_[link.real] += force / mass_[link.real];
            velocity_[link.real] += clock.dt / mass_[link.real] * force;
        }
        this->setLoad(reaction);
    }
    for (const Index i : images_) velocity_[i].setZero();
    for (const ImageLink& link : links_)
        velocity_[link.image] += link.weight * velocity_[link.real];
}

namespace {

/// Some of the body must be left to move.
template <int Dim>
void checkRest(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<ClampParameters>();
    const ConstPart<Dim> part(built.world, p.part);
    if (part.size() < part.body().size()) return;
    built.diagnostics.error(
        p.part.place,
        fmt::format("nothing of {} would be left to move: a clamp needs a part of it, "
                    "on whose surface it holds the other particles",
                    part.body().name));
}

}  // namespace

void declareClamp(input::Registry& registry) {
    using P = ClampParameters;
    auto& d = declareMethod<P>(
        registry, "constraint.clamp", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<Clamp<Dim>>(context, Part<Dim>(context.world, p.part));
        });
    d.summary(
        "Clamps an elastic body along the surface of a part, wherever it runs through the lattice; "
        "particles within mirror the motion of the others");
    d.formula(
        "u = 0 on the surface: u_g = sum_k c_gk u_k, f_k += sum_g c_gk f_g; sum_k c_gk = -1, or "
        "distance/(0.75 dp) where the surface cuts a cell, which is strained as far as it lies "
        "outside");
    d.cite("Libersky et al. 1993", "(mirror particles)");
    d.required("part", &P::part, input::partReference({"elastic"}),
               "part of a body; particles that it covers by more than a quarter have no mass");
    d.worldRule([](const auto& method, auto& built) { checkRest(method, built); });
    d.action("between the halves of the step, and at the start before the correction")
        .reads("part", {"initial_position", "volume", "velocity", "mass", "acceleration",
                        "external_acceleration", "pressure_force", "viscous_force"})
        .writes("part", {"velocity", "acceleration"})
        .within("part", "step")
        .throughout(
            "the particles behind its surface have no mass of their own as long as it is there; "
            "constraint.fix can let go");
}

template class Clamp<2>;
template class Clamp<3>;

}  // namespace sphinx::dynamics::constraint
