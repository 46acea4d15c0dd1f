// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/checks.h"

#include "neighbors/list_builder.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sphinx::check {
namespace {

/// Of the speed, along the normal: a circle drawn as a polygon of 64 sides slides along itself.
constexpr double part_along_normal = 0.05;
/// Of the surface of a body that no fluid has come up to: a belt has ends, too, and slides.
constexpr double part_of_belt = 0.25;

/// Whether a line of the loop gives the body its velocity.
bool isMoved(const model::Case& model, const model::Body& body) {
    for (const input::Component& method : model.dynamics) {
        if (!model.calls(method.name)) continue;
        for (const input::Action& action : method.declaration->actions())
            for (const input::Access& access : action.accesses()) {
                if (!input::changes(access.mode) || access.field != fields::velocity.name) continue;
                for (const input::Name& name :
                     method.references(model::splitAction(access.owner).first))
                    if (model::splitAction(name.text).first == body.name) return true;
            }
    }
    return false;
}

/// What a body does at its surface.
template <int Dim>
struct Surface {
    AlignedVector<Vec<Dim>> ahead;  ///< points in front of the particles of the surface
    std::vector<std::size_t> particle;
    std::vector<bool> pushes;  ///< by particle of the body: it moves along the normal
    std::size_t particles = 0;
    std::size_t pushing = 0;
};

template <int Dim>
Surface<Dim> surfaceOf(const bodies::Body<Dim>& wall, double spacing, double reach) {
    const auto& position = wall.particles.position();
    const auto& velocity = wall.particles.vector(fields::velocity);
    Surface<Dim> surface;
    surface.pushes.resize(wall.size());
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const double distance = wall.shape->signedDistance(position[i]);
        if (distance < -wall.spacing) continue;
        const Vec<Dim> normal = wall.shape->normal(position[i]);
        surface.pushes[i] =
            std::abs(velocity[i].dot(normal)) > part_along_normal * velocity[i].norm();
        ++surface.particles;
        if (surface.pushes[i]) ++surface.pushing;
        for (double d = 0.5 * spacing; d < reach; d += spacing) {
            surface.ahead.push_back(position[i] + (d - distance) * normal);
            surface.particle.push_back(i);
        }
    }
    return surface;
}

/// Particles of the wall that have fluid in front of them.
template <int Dim>
std::vector<std::size_t> touching(const Surface<Dim>& surface, const bodies::World<Dim>& world,
                                  const bodies::Body<Dim>& fluid) {
    const double limit = 0.75 * fluid.spacing;
    neighbors::CellGrid<Dim> points, particles;
    points.build(surface.ahead.data(), surface.ahead.size(), fluid.spacing);
    particles.build(fluid.particles.position().data(), fluid.size(), fluid.spacing);
    // Not through a periodic side: where a wall ends there it goes on.
    bodies::Domain<Dim> domain = world.domain;
    domain.periodic = {};
    const kernels::Kernel<Dim> kernel(kernels::KernelType::wendland_c2,
                                      limit / kernels::WendlandC2<Dim>::reach, limit);
    neighbors::NeighborList<Dim> list;
    neighbors::buildList(points, particles, false, kernel, domain, list);
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < surface.particle.size(); ++k)
        if (list.ranges[k].count > 0) found.push_back(surface.particle[k]);
    return found;
}

template <int Dim>
void checkStanding(const model::Body& source, const bodies::World<Dim>& world,
                   input::Diagnostics& diagnostics) {
    const bodies::Body<Dim>& wall = *world.find(source.name);
    const auto& velocity = wall.particles.vector(fields::velocity);
    const auto still = [&](std::size_t i) { return velocity[i].squaredNorm() == 0; };
    std::size_t first = 0;
    while (first < wall.size() && still(first)) ++first;
    if (first == wall.size()) return;

    const std::string stands = wall.name +
                               " stands still: a rigid body moves by "
                               "constraint.prescribed_motion; its initial velocity ";
    const auto fail = [&](std::size_t i, const std::string& what) {
        const Vec<Dim>& x = wall.particles.position()[i];
        const double along = velocity[i].dot(wall.shape->normal(x));
        diagnostics.error(
            source.initial.place,
            fmt::format("{}is for one that slides along its surface, but at {} that is {} along "
                        "the normal{}",
                        stands, world.placeText(x), world.quantityText(along, unit::velocity),
                        what));
    };
    bool seen = false;
    bool touched = false;
    std::optional<std::size_t> pushing;
    for (const auto& fluid : world.bodies) {
        if (!fluid->isFluid() || std::ranges::find(fluid->sees, &wall) == fluid->sees.end())
            continue;
        seen = true;
        if (!wall.shape) return;
        const Surface<Dim> surface = surfaceOf(wall, fluid->spacing, fluid->kernel.cutoff());
        const std::vector<std::size_t> particles = touching(surface, world, *fluid);
        touched = touched || !particles.empty();
        for (const std::size_t i : particles)
            if (surface.pushes[i]) return fail(i, ", which would push " + fluid->name);
        if (static_cast<double>(surface.pushing) >
            part_of_belt * static_cast<double>(surface.particles))
            pushing = static_cast<std::size_t>(std::ranges::find(surface.pushes, true) -
                                               surface.pushes.begin());
    }
    if (!seen)
        diagnostics.error(source.initial.place, stands + "does nothing, as no fluid sees it");
    else if (!touched && pushing)
        fail(*pushing, "");
}

}  // namespace

template <int Dim>
void checkStandingWalls(const model::Case& model, const bodies::World<Dim>& world,
                        input::Diagnostics& diagnostics) {
    if (diagnostics.hasErrors()) return;
    for (const model::Body& source : model.bodies)
        if (source.role == bodies::Role::wall && source.initial.velocity && !isMoved(model, source))
            checkStanding<Dim>(source, world, diagnostics);
}

template void checkStandingWalls(const model::Case&, const bodies::World<2>&, input::Diagnostics&);
template void checkStandingWalls(const model::Case&, const bodies::World<3>&, input::Diagnostics&);

}  // namespace sphinx::check
