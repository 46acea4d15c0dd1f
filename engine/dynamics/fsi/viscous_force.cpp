// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/viscous_force.h"

namespace sphinx::fsi {

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
    d.action()
        .reads("body", {"normal", "depth", "volume", "average_velocity", "neighbors"})
        .reads("from", {"velocity", "volume", "fresh_viscous_load"})
        .accumulates("body", {"viscous_force"});
}

}  // namespace sphinx::fsi
