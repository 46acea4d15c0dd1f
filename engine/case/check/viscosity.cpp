// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/viscosity.h"

#include "dynamics/fluid/viscous_force.h"
#include "dynamics/fsi/fluid_force.h"
#include "materials/weakly_compressible_fluid.h"

#include <fmt/format.h>

namespace sphinx::model {

void checkViscosity(const Case& model, input::Diagnostics& diagnostics) {
    for (const Body& body : model.bodies) {
        if (body.role != Role::fluid) continue;
        const Component& material = *model.findMaterial(body.material.text);
        const bool viscous = material.as<WeaklyCompressibleFluidParameters>().viscosity > 0;
        bool applied = false;
        bool sticks = false;  // to solids
        for (const Component& method : model.dynamics) {
            if (method.declaration->name() != "fluid.viscous_force" || !model.calls(method.name))
                continue;
            const auto& p = method.as<fluid::ViscousForceParameters>();
            if (p.body.text != body.name) continue;
            applied = true;
            sticks = sticks || p.wall == fluid::WallSlip::no_slip;
            if (!viscous)
                diagnostics.warning(method.place,
                                    fmt::format("{} does nothing: the viscosity of {} is 0",
                                                method.name, material.name));
        }
        for (const Component& method : model.dynamics)
            if (applied && !sticks && method.declaration->name() == "fsi.viscous_force" &&
                method.as<fsi::FluidForceParameters>().from.text == body.name)
                diagnostics.warning(method.place,
                                    fmt::format("{} does nothing: by 'wall: free_slip' solids "
                                                "exert no viscous force on {}",
                                                method.name, body.name));
        if (viscous && !applied)
            diagnostics.warning(material.placeOf("viscosity"),
                                fmt::format("nothing applies the viscosity of {}: the loop "
                                            "calls no fluid.viscous_force for it",
                                            body.name));
    }
}

}  // namespace sphinx::model
