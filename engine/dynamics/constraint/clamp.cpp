// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/arrangement_watch.h"
#include "dynamics/constraint/mirror_images.h"
#include "dynamics/methods.h"
#include "dynamics/outer_forces.h"
#include "dynamics/part_method.h"
#include "dynamics/radiation.h"

#include <fmt/format.h>

namespace sphinx::dynamics::constraint {
namespace {

/// Holds an elastic body along the surface of a part: u = 0 there. Particles of whose cells the
/// part covers more than a quarter are images: they mirror the motion of the others, u_g = sum_k
/// c_gk u_k, without mass of their own, and hand the forces that they feel on to them, f_k += sum_g
/// c_gk f_g. Each particle is strained as far as its cell lies outside of the part
/// (ElasticRole::shares), so that the surface is met wherever it runs through the lattice. The
/// motion is that of this energy, without loss. constraint.fix, where the particles of the part
/// stand still and share stress and strain with the others, holds the body 0.6 to 0.8 spacings
/// behind that surface instead: the first of them stands half a spacing behind it and shares the
/// strain. Between the halves of the step; at the start, it gives the images their velocity.
struct ClampParameters {
    input::Name part;
};

template <int Dim>
class Clamp final : public PartMethod<Support, Dim> {
 public:
    Clamp(Context<Dim>& context, const ClampParameters& p)
        : Clamp::PartMethod(Part<Dim>(context.world, p.part)),
          relations_(&context.relations),
          body_(&this->part().body()),
          relation_(&context.relations.reference(*body_, *body_)),
          position_(body_->particles.position()),
          velocity_(body_->particles.vector(fields::velocity)),
          acceleration_(body_->particles.vector(fields::acceleration)),
          outer_(body_->particles),
          radiation_(body_->particles),
          mass_(body_->particles.scalar(fields::mass)) {}
    void announce() override { this->part().mirror(); }
    void prepare() override { findImages(); }
    void run(const Clock& clock);

 private:
    /// Where the particles have other places than those found.
    void findImages();

    Relations<Dim>* relations_;
    Body<Dim>* body_;
    ReferenceRelation<Dim>* relation_;
    std::vector<Index> images_;
    std::vector<ImageLink> links_;
    ArrangementWatch watch_;  // of the particles that these name

    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& acceleration_;
    OuterForces<Dim> outer_;
    Radiation<Dim> radiation_;
    Field<double>& mass_;
};

template <int Dim>
void Clamp<Dim>::findImages() {
    if (!watch_.hasChanged(body_->particles)) return;
    relations_->build(*relation_);
    images_ = this->part().images();
    links_ = mirrorImages(this->part(), images_, *relation_, relations_->domain());
}

template <int Dim>
void Clamp<Dim>::run(const Clock& clock) {
    findImages();
    if (!clock.is_start) {
        const auto load = [&](Index i) -> Vec<Dim> {
            return mass_[i] * outer_.external[i] + outer_.pressure[i] + outer_.viscous[i];
        };
        radiation_.begin(clock.dt);
        Load<Dim> reaction;
        for (const Index i : images_) reaction.add(position_[i], -mass_[i] * acceleration_[i]);
        for (const ImageLink& link : links_) {
            const Index i = link.image;
            const Vec<Dim> force = link.weight * (mass_[i] * acceleration_[i] - load(i));
            reaction.add(position_[link.real], force);
            const Vec<Dim> a = radiation_.acceleration(link.real, force);
            acceleration_[link.real] += a;
            velocity_[link.real] += clock.dt * a;
        }
        this->setLoad(reaction);
    }
    for (const Index i : images_) velocity_[i].setZero();
    for (const ImageLink& link : links_)
        velocity_[link.image] += link.weight * velocity_[link.real];
}

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
    auto& d = declareMethod<Clamp, P>(registry, "constraint.clamp");
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
        .mayRead("part", {"radiation_impedance"})
        .writes("part", {"velocity", "acceleration"})
        .within("part", "step")
        .throughout(
            "the particles behind its surface have no mass of their own as long as it is there; "
            "constraint.fix can let go");
}

}  // namespace sphinx::dynamics::constraint
