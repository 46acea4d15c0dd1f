// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/implicit_viscosity.h"
#include "dynamics/fsi/fluid_force.h"
#include "dynamics/methods.h"

#include <fmt/format.h>

namespace sphinx::dynamics::fsi {
namespace {

/// Solids that the fluid does not stick to get no viscous force.
template <int Dim>
void checkEffect(const input::Component& method, BuiltCase<Dim>& built) {
    const std::string& fluid = method.as<FluidForceParameters>().from.text;
    bool applied = false;
    bool sticks = false;
    const auto look = [&](const auto* p) {
        if (!p || p->body.text != fluid) return;
        applied = true;
        sticks = sticks || p->wall == fluid::WallSlip::no_slip;
    };
    for (const input::Component* other : built.called) {
        look(other->template find<fluid::ViscousForceParameters>());
        look(other->template find<fluid::ImplicitViscosityParameters>());
    }
    if (applied && !sticks)
        built.diagnostics.warning(
            method.place, fmt::format("{} does nothing: by 'wall: free_slip' solids exert no "
                                      "viscous force on {}",
                                      method.name, fluid));
}

}  // namespace

void declareViscousForce(input::Registry& registry) {
    auto& d = declareFluidForce<fluid::LoadKind::viscous>(registry, "fsi.viscous_force", "drags");
    d.summary(
        "Viscous force of a fluid on the particles of an elastic body; after the fluid's "
        "viscous force, before its velocity changes");
    d.formula("minus what the fluid has felt, see fluid.viscous_force");
    d.worldRule([](const auto& method, auto& built) { checkEffect(method, built); });
    d.action()
        .reads("body", {"normal", "depth", "volume", "average_velocity", "neighbors"})
        .reads("from", {"velocity", "volume", "fresh_viscous_load"})
        .accumulates("body", {"viscous_force"});
}

}  // namespace sphinx::dynamics::fsi
