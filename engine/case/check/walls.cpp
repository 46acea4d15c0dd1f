// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/checks.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::check {
namespace {

constexpr int layers_needed = 3;
/// Of the particles at the surface; fewer are the tips of wedges, which are thin anyhow.
constexpr double part_that_counts = 0.125;

/// Particles below this one along the inward normal of the surface, itself included.
template <int Dim>
int layersAt(const bodies::Body<Dim>& body, const Vec<Dim>& point) {
    const Vec<Dim> inwards = -body.spacing * body.shape->normal(point);
    int layers = 1;
    while (layers < layers_needed && body.shape->contains(point + layers * inwards)) ++layers;
    return layers;
}

template <int Dim>
void checkThickness(const model::Body& source, const bodies::World<Dim>& world,
                    const bodies::Body<Dim>& wall, const bodies::Body<Dim>& fluid,
                    input::Diagnostics& diagnostics) {
    const auto& position = wall.particles.position();
    std::size_t surface = 0;
    std::size_t thin = 0;
    int fewest = layers_needed;
    Vec<Dim> first = Vec<Dim>::Zero();
    for (std::size_t i = 0; i < wall.size(); ++i) {
        if (wall.shape->signedDistance(position[i]) < -wall.spacing) continue;
        ++surface;
        const int layers = layersAt(wall, position[i]);
        if (layers >= layers_needed) continue;
        if (thin++ == 0) first = position[i];
        fewest = std::min(fewest, layers);
    }
    if (thin > 0 && static_cast<double>(thin) >= part_that_counts * static_cast<double>(surface))
        diagnostics.warning(
            source.place,
            fmt::format("{} is only {} layer{} of particles thick, first at {}; {} may leak "
                        "through fewer than {}",
                        wall.name, fewest, fewest == 1 ? "" : "s", world.placeText(first),
                        fluid.name, layers_needed));
}

/// A rigid body acts on those that see it, and on nothing else.
void checkSeen(const model::Case& model, input::Diagnostics& diagnostics) {
    for (const model::Body& wall : model.bodies) {
        if (wall.role != bodies::Role::wall || model.responds(wall)) continue;
        const bool seen = std::any_of(
            model.topology.begin(), model.topology.end(), [&](const model::Sight& sight) {
                const model::Body& seer = *model.findBody(sight.body.text);
                return (seer.role == bodies::Role::fluid || model.responds(seer)) &&
                       std::any_of(
                           sight.sees.begin(), sight.sees.end(),
                           [&](const model::Seen& one) { return one.body.text == wall.name; });
            });
        if (!seen)
            diagnostics.warning(wall.place, fmt::format("no fluid or elastic body sees {} in "
                                                        "topology: it holds nothing back",
                                                        wall.name));
    }
}

}  // namespace

template <int Dim>
void checkWalls(const model::Case& model, const bodies::World<Dim>& world,
                input::Diagnostics& diagnostics) {
    checkSeen(model, diagnostics);
    for (const auto& solid : world.bodies) {
        if (!solid->isSolid()) continue;
        const bodies::Body<Dim>* finest = nullptr;  // of the fluids that see it
        for (const auto& fluid : world.bodies)
            if (fluid->isFluid() &&
                std::find(fluid->sees.begin(), fluid->sees.end(), solid.get()) !=
                    fluid->sees.end() &&
                (!finest || fluid->spacing < finest->spacing))
                finest = fluid.get();
        if (!finest) continue;
        const model::Body& source = *model.findBody(solid->name);
        if (solid->spacing > finest->spacing * (1 + 1e-9))
            diagnostics.warning(
                source.place,
                fmt::format("{} has a spacing of {}, coarser than the {} of {}, which may leak",
                            solid->name, world.quantityText(solid->spacing, unit::length),
                            world.quantityText(finest->spacing, unit::length), finest->name));
        if (solid->shape && solid->isWall())
            checkThickness<Dim>(source, world, *solid, *finest, diagnostics);
    }
}

template void checkWalls(const model::Case&, const bodies::World<2>&, input::Diagnostics&);
template void checkWalls(const model::Case&, const bodies::World<3>&, input::Diagnostics&);

}  // namespace sphinx::check
