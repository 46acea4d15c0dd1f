// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact/force.h"

#include "dynamics/contact/density_pair.h"
#include "dynamics/contact/rules.h"
#include "dynamics/contact/surface_pair.h"
#include "dynamics/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace sphinx::dynamics::contact {
namespace {

/// A modulus M over a layer dp: of each body that gives way, half a spacing of material between its
/// outermost row and its surface, which no particles strain. So kappa = 1/sum(dp/(2 M)).
template <int Dim>
PairLaw layerOf(const ForceParameters& p, const Body<Dim>& a, const Body<Dim>& b) {
    double compliance = 0;
    PairLaw law;
    for (const Body<Dim>* body : {&a, &b}) {
        if (body->isElastic()) law.thickness += 0.5 * body->spacing;
        if (p.modulus)
            compliance += 0.5 * body->spacing / *p.modulus;
        else if (body->isElastic())
            compliance += 0.5 * body->spacing / body->elastic().material->longitudinalModulus();
    }
    law.stiffness = 1 / compliance;
    return law;
}

/// rho0 c0^2 of the guide; that of the softer body.
template <int Dim>
double bulkModulusOf(const ForceParameters& p, const Body<Dim>& a, const Body<Dim>& b) {
    if (p.modulus) return *p.modulus;
    double modulus = std::numeric_limits<double>::infinity();
    for (const Body<Dim>* body : {&a, &b})
        if (body->isElastic()) modulus = std::min(modulus, body->elastic().material->bulkModulus());
    return modulus;
}

/// Those that all contacts of the body share.
template <int Dim>
Loads<Dim>& loadsOf(Context<Dim>& context, Body<Dim>& body) {
    for (const auto& loads : context.contact_loads)
        if (&loads->body() == &body) return *loads;
    return *context.contact_loads.emplace_back(std::make_shared<Loads<Dim>>(body));
}

template <int Dim>
class Force final : public Method, public PairOwner<Dim> {
 public:
    Force(Context<Dim>& context, const ForceParameters& p);
    void run(const Clock& clock);
    void rest() override {
        for (const auto& surface : surfaces_) {
            surface->loads().clear();
            surface->release();
        }
    }
    void transfer(Archive& archive) override;
    std::size_t workSize() const override;
    const std::vector<std::unique_ptr<Pair<Dim>>>& pairs() const override { return pairs_; }
    void takePlaces(double dt) override;

 private:
    std::vector<std::unique_ptr<Surface<Dim>>> surfaces_;
    std::vector<std::unique_ptr<Pair<Dim>>> pairs_;
};

template <int Dim>
Force<Dim>::Force(Context<Dim>& context, const ForceParameters& p) {
    const bool by_density = p.form == Form::density;
    const Domain<Dim>& domain = context.world.domain;
    const auto surface = [&](const input::Name& name) {
        Body<Dim>& body = bodyOf(context, name);
        const double depth = by_density ? body.kernel.cutoff() : body.spacing;
        surfaces_.push_back(std::make_unique<Surface<Dim>>(domain, body, loadsOf(context, body),
                                                           depth, !by_density));
        return surfaces_.back().get();
    };
    Surface<Dim>* own = surface(p.body);
    for (const input::Name& name : p.with) {
        Surface<Dim>* other = name.text == p.body.text ? own : surface(name);
        PairLaw law = layerOf(p, own->body(), other->body());
        law.coulomb = p.friction.coulomb.value_or(0);
        law.viscous = p.friction.viscous.value_or(0);
        law.restitution = p.restitution;
        if (by_density) {
            law.stiffness = bulkModulusOf(p, own->body(), other->body()) /
                            std::max(own->body().spacing, other->body().spacing);
            pairs_.push_back(std::make_unique<DensityPair<Dim>>(domain, *own, *other, law));
        } else {
            pairs_.push_back(std::make_unique<SurfacePair<Dim>>(domain, *own, *other, law));
        }
    }
    context.contacts.push_back(this);
    for (const auto& one : surfaces_) context.contact_stresses.push_back(&one->stress());
}

template <int Dim>
void Force<Dim>::takePlaces(double dt) {
    for (const auto& surface : surfaces_) surface->update(dt);
}

template <int Dim>
void Force<Dim>::run(const Clock& clock) {
    if (clock.is_start) return;
    takePlaces(clock.dt);
    for (const auto& surface : surfaces_) {
        surface->loads().begin(clock);
        surface->release();
    }
    for (const auto& pair : pairs_) pair->act(clock.dt);
    for (const auto& surface : surfaces_) surface->finish();
}

template <int Dim>
void Force<Dim>::transfer(Archive& archive) {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const Section section(archive, fmt::format("pair_{}", k));
        pairs_[k]->transfer(archive);
    }
}

template <int Dim>
std::size_t Force<Dim>::workSize() const {
    std::size_t n = 0;
    for (const auto& surface : surfaces_) n += surface->size();
    return n;
}

const input::Declaration& declareFriction(input::Registry& registry) {
    using P = FrictionParameters;
    auto& d = registry.declare<P>(input::Kind::block, "contact.force.friction");
    d.summary("Friction of two surfaces");
    d.optional(
        "coulomb", &P::coulomb, input::number(unit::none).atLeast(0),
        "coefficient of dry friction: the force along the surface over that across it, at most");
    d.optional("viscous", &P::viscous, input::number(unit::dynamic_viscosity).atLeast(0),
               "viscosity of a layer a spacing thick between both");
    d.check("", [](const P& p) -> std::string {
        return p.coulomb.has_value() == p.viscous.has_value()
                   ? "friction is either 'coulomb' or 'viscous'"
                   : "";
    });
    return d;
}

}  // namespace

void declareForce(input::Registry& registry) {
    using P = ForceParameters;
    auto& d = declareMethod<Force, P>(registry, "contact.force");
    d.summary("Keeps the surfaces of solids apart, with friction");
    d.formula(
        "pressure -kappa d ln(1 - abs(g)/d) where the gap g of two surfaces is negative: a layer "
        "of d = sum(dp/2) and 1/kappa = sum(dp/(2 M)) over the bodies that give way, M = rho0 "
        "c_P^2; kappa abs(g) between rigid bodies; friction at most mu times the normal force, or "
        "that of "
        "a viscous layer");
    d.cite("guide", "(36), (37)").cite("Schwager & Poeschel 2007", "(restitution)");
    d.required("body", &P::body, input::bodyReference({"solid"}), "solid body");
    d.optional(
        "with", &P::with, input::list(input::bodyReference({"solid"})),
        "bodies that it touches, itself for self-contact, which get the reaction; without: all of "
        "{contact: ...} in its topology");
    d.optional(
        "form", &P::form,
        input::choice<Form>(
            {{"surfaces", Form::surfaces, "surfaces touch where the shapes do"},
             {"density", Form::density,
              "contact density and pressure by a kernel sum, guide (36) and (37): bodies rest "
              "about a spacing apart; friction is viscous only"}}),
        "how the force is found");
    d.check("form", [](const P& p) -> std::string {
        if (p.form == Form::surfaces) return "";
        if (p.friction.coulomb) return "form: density has viscous friction only";
        return p.restitution < 1 ? "form: density has no restitution" : "";
    });
    d.optional("modulus", &P::modulus, input::number(unit::pressure).above(0),
               "stiffness M of the layer of contact; without: that of the elastic bodies");
    d.optional("friction", &P::friction,
               input::structure<FrictionParameters>(declareFriction(registry)),
               "friction; without: none");
    d.optional("restitution", &P::restitution, input::number(unit::none).above(0).atMost(1),
               "of two rigid bodies: speed after a blow over that before");
    d.rule(checkPairs);
    d.worldRule([](const auto& method, auto& built) { checkShapes(method, built); });
    d.caseRule([](auto& built) { checkContacts(built); });
    d.action(
         "before the first half of the steps of elastic bodies, or the step of the mechanism, in "
         "the same layer")
        .reads("body", {"initial_position", "position", "velocity", "volume", "normal",
                        "initial_normal", "depth"})
        .reads("with", {"initial_position", "position", "velocity", "volume", "normal",
                        "initial_normal", "depth"})
        .reads("body.elastic", {"deformation_gradient", "deformation_rate"})
        .reads("with.elastic", {"deformation_gradient", "deformation_rate"})
        .tells("body", {"contact_force", "contact_pressure"})
        .tells("with", {"contact_force", "contact_pressure"})
        .tells("body.carried", {"contact_couple"})
        .tells("with.carried", {"contact_couple"});
}

}  // namespace sphinx::dynamics::contact
