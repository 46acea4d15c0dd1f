// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/world.h"

#include "case/build/initial_values.h"
#include "case/build/relaxed.h"
#include "case/check/checks.h"
#include "case/language/changes.h"
#include "core/errors.h"
#include "materials/register.h"

#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace sphinx::build {
namespace {

template <int Dim>
bodies::Domain<Dim> makeDomain(const model::Case& model) {
    bodies::Domain<Dim> domain;
    for (const model::Shape& shape : model.shapes)
        if (!shape.as<Dim>()->empty()) domain.bounds.include(shape.as<Dim>()->bounds());
    // Room for what splashes over a rim. (A periodic domain states both of its bounds.)
    const Vec<Dim> room = Vec<Dim>::Constant(domain.bounds.size().maxCoeff());
    domain.bounds.lower -= room;
    domain.bounds.upper += room;
    if (model.domain.lower) domain.bounds.lower = model.domain.lower->as<Dim>();
    if (model.domain.upper) domain.bounds.upper = model.domain.upper->as<Dim>();
    for (const int axis : model.domain.periodic)
        domain.periodic[static_cast<std::size_t>(axis)] = true;
    domain.lost = model.domain.lost;
    return domain;
}

/// The role of a body of that material; its kind and the material's are known to agree.
template <int Dim>
decltype(bodies::Body<Dim>::role) makeRole(bodies::Role role,
                                           std::shared_ptr<const materials::Material> material) {
    switch (role) {
        case bodies::Role::fluid:
            return bodies::FluidRole<Dim>{
                std::dynamic_pointer_cast<const materials::Fluid>(material)};
        case bodies::Role::elastic:
            return bodies::ElasticRole<Dim>{
                std::dynamic_pointer_cast<const materials::ElasticSolid>(material)};
        case bodies::Role::wall: return bodies::WallRole{std::move(material)};
        case bodies::Role::observer: break;
    }
    return bodies::ObserverRole{};
}

/// Cases of the first version of the language had the points of a lattice on both of two opposite
/// faces, and all those on any surface.
template <int Dim>
void warnMoved(const model::Body& body, const PlacedLattice<Dim>& placed,
               input::Diagnostics& diagnostics) {
    const auto warn = [&](const std::string& text) {
        language::warnChange(body.place, 2, text, diagnostics);
    };
    if (placed.moved != std::array<bool, Dim>{})
        warn(
            "a lattice whose points would fall on opposite faces of the body moves by half a "
            "spacing");
    if (placed.on_surface > 0)
        warn(
            "a lattice point on the surface of a body is its particle only where the body goes on "
            "towards larger coordinates");
}

/// Particles of a lattice along periodic axes: a face shared by both ends belongs to one of them.
template <int Dim>
void keepOnePeriod(std::vector<Vec<Dim>>& points, const bodies::Domain<Dim>& domain) {
    std::erase_if(points, [&](const Vec<Dim>& p) {
        for (int k = 0; k < Dim; ++k)
            if (domain.periodic[static_cast<std::size_t>(k)] &&
                (p[k] < domain.bounds.lower[k] || p[k] >= domain.bounds.upper[k]))
                return true;
        return false;
    });
}

/// The rule that the material has for the places of its particles; the first mistake stands for
/// all.
template <int Dim>
void checkPlaces(const input::Component& material, const std::vector<Vec<Dim>>& places,
                 input::Diagnostics& diagnostics) {
    const auto& rule = material.declaration->builder<materials::MaterialBuilder>().place_rule;
    if (!rule) return;
    for (const Vec<Dim>& place : places)
        if (const auto violation = rule->check(material.parameters.get(), place)) {
            diagnostics.error(material.placeOf(violation->parameter), violation->message);
            diagnostics.throwIfErrors();
        }
}

/// Displaces each point by up to a quarter of a spacing along each axis. The generator is the one
/// that the standard defines to the bit, so it is the same everywhere.
template <int Dim>
void jitter(std::vector<Vec<Dim>>& points, double spacing) {
    std::mt19937_64 generator;
    for (Vec<Dim>& point : points)
        for (double& component : point)
            component +=
                0.5 * spacing * (std::ldexp(static_cast<double>(generator() >> 11), -53) - 0.5);
}

template <int Dim>
void makeParticles(const model::Case& model, const model::Body& source,
                   const bodies::World<Dim>& world, PlacedLattice<Dim>& placed,
                   bodies::Body<Dim>& body, input::Diagnostics& diagnostics) {
    std::vector<Vec<Dim>> points;
    std::vector<double> volumes;
    if (source.role == bodies::Role::observer) {
        for (const input::Coordinates& p : source.points) points.push_back(p.as<Dim>());
    } else if (source.particles) {
        for (const input::Coordinates& p : source.particles->points) points.push_back(p.as<Dim>());
        volumes = source.particles->volumes;
    } else if (source.arrangement == model::Arrangement::relaxed) {
        relaxPoints(source, body, world, placed, diagnostics);
        points = std::exchange(placed.points, {});
        volumes.assign(points.size(), placed.relaxed->volume);
    } else {
        points = std::exchange(placed.points, {});
        keepOnePeriod(points, world.domain);
        if (model.version < 2) warnMoved(source, placed, diagnostics);
        if (source.arrangement == model::Arrangement::jittered) jitter(points, body.spacing);
    }
    if (volumes.empty()) volumes.assign(points.size(), std::pow(body.spacing, Dim));

    if (const input::Component* material = model.findMaterial(source.material.text))
        checkPlaces<Dim>(*material, points, diagnostics);
    std::vector<bodies::NewParticle<Dim>> particles(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        particles[i].position = points[i];
        particles[i].volume = volumes[i];
    }
    try {
        giveInitialValues(source, model.loop.start_time, particles);
    } catch (const PhysicsError& e) {
        diagnostics.error(source.place, e.what());
        diagnostics.throwIfErrors();
    }
    bodies::addParticles(body, particles);
}

}  // namespace

template <int Dim>
std::unique_ptr<bodies::World<Dim>> buildWorld(const model::Case& model, bool particles,
                                               input::Diagnostics& diagnostics,
                                               std::map<std::string, PlacedLattice<Dim>>* placed) {
    check::checkLattices<Dim>(model, diagnostics);
    diagnostics.throwIfErrors();
    auto world = std::make_unique<bodies::World<Dim>>();
    world->units = model.units;
    world->domain = makeDomain<Dim>(model);
    world->precision = model.resolution.precision;
    for (const model::Shape& shape : model.shapes) world->shapes[shape.name] = shape.as<Dim>();

    std::map<std::string, std::shared_ptr<const materials::Material>> materials;
    for (const input::Component& material : model.materials)
        materials[material.name] = material.declaration->builder<materials::MaterialBuilder>().make(
            material.parameters.get());

    std::map<std::string, PlacedLattice<Dim>> lattices;
    if (particles) lattices = placeLattices<Dim>(model, world->domain);
    for (const model::Body& source : model.bodies) {
        auto body = std::make_unique<bodies::Body<Dim>>();
        body->name = source.name;
        if (!source.material.empty())
            body->role = makeRole<Dim>(source.role, materials.at(source.material.text));
        if (auto* wall = std::get_if<bodies::WallRole>(&body->role))
            wall->in_mechanism = model.responds(source);
        if (!source.shape.empty()) body->shape = model.findShape(source.shape.text)->as<Dim>();
        body->spacing = source.spacing(model.resolution);
        body->on_lattice = source.arrangement != model::Arrangement::relaxed;
        const double h = source.smoothingRatio(model.resolution) * body->spacing;
        body->kernel = kernels::Kernel<Dim>(source.kernel(model.resolution), h, body->spacing);
        for (const model::Part& part : source.parts)
            body->parts.push_back({part.name, {}, model.findShape(part.shape.text)->as<Dim>()});
        if (particles || source.role == bodies::Role::observer)
            makeParticles(model, source, *world, lattices[source.name], *body, diagnostics);
        else
            bodies::addParticles(*body, {});
        world->bodies.push_back(std::move(body));
    }
    for (auto& body : world->bodies)
        for (const model::Seen& seen : model.seenBy(body->name)) {
            bodies::Body<Dim>* other = world->find(seen.body.text);
            if (seen.as == model::SeenAs::flow) body->sees.push_back(other);
            if (seen.as == model::SeenAs::bonded) body->bonded.push_back(other);
        }
    for (auto& body : world->bodies)
        if (body->isObserver() && !body->sees.empty()) {
            body->spacing = body->sees.front()->spacing;
            body->kernel = body->sees.front()->kernel;
        }
    if (particles) {
        check::checkParticles(model, *world, diagnostics);
        check::checkElastic(model, *world, diagnostics);
        check::checkWalls(model, *world, diagnostics);
        check::checkStandingWalls(model, *world, diagnostics);
        check::checkWorldRules(model, *world, diagnostics);
    }
    if (placed) *placed = std::move(lattices);
    return world;
}

template std::unique_ptr<bodies::World<2>> buildWorld(const model::Case&, bool, input::Diagnostics&,
                                                      std::map<std::string, PlacedLattice<2>>*);
template std::unique_ptr<bodies::World<3>> buildWorld(const model::Case&, bool, input::Diagnostics&,
                                                      std::map<std::string, PlacedLattice<3>>*);

}  // namespace sphinx::build
