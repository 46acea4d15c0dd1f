// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/viscous_force.h"

#include "dynamics/fluid/viscous_force.h"

#include <fmt/format.h>

namespace sphinx::dynamics::fsi {

namespace {

/// Solids that the fluid does not stick to get no viscous force.
template <int Dim>
void checkEffect(const input::Component& method, BuiltCase<Dim>& built) {
    const std::string& fluid = method.as<FluidForceParameters>().from.text;
    bool applied = false;
    bool sticks = false;
    for (const input::Component* other : built.called) {
        const auto* p = other->template find<fluid::ViscousForceParameters>();
        if (!p || p->body.text != fluid) continue;
        applied = true;
        sticks = sticks || p->wall == fluid::WallSlip::no_slip;
    }
    if (applied && !sticks)
        built.diagnostics.warning(
            method.place, fmt::format("{} does nothing: by 'wall: free_slip' solids exert no "
                                      "viscous force on {}",
                                      method.name, fluid));
}

}  // namespace

void declareViscousForce(input::Registry& registry) {
    using P = FluidForceParameters;
    auto& d = declareMethod<P>(
        registry, "fsi.viscous_force", []<int Dim>(const P& p, Context<Dim>& context) {
            Body<Dim>& body = bodyOf(context, p.body);
            return std::make_unique<FluidForce<Dim>>(context, body, bodyOf(context, p.from),
                                                     fluid::LoadKind::viscous,
                                                     body.particles.vector(fields::viscous_force));
        });
    d.summary(
        "Viscous force of a fluid on the particles of an elastic body; after the fluid's "
        "viscous force, before its velocity changes");
    d.formula("minus what the fluid has felt, see fluid.viscous_force");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.required("from", &P::from, input::bodyReference({"fluid"}), "fluid that drags it");
    d.rule(checkSight);
    d.worldRule([](const auto& method, auto& built) { checkEffect(method, built); });
    d.action()
        .reads("body", {"normal", "depth", "volume", "average_velocity", "neighbors"})
        .reads("from", {"velocity", "volume", "fresh_viscous_load"})
        .accumulates("body", {"viscous_force"});
}

}  // namespace sphinx::dynamics::fsi
