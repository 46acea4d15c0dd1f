// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check_viscosity.h"

#include "dynamics/fluid/viscous_force.h"
#include "materials/fluid.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::model {

void checkViscosity(const Case& model, input::Diagnostics& diagnostics) {
    for (const Body& body : model.bodies) {
        if (body.kind != BodyKind::fluid) continue;
        const Component& material = *model.findMaterial(body.material.text);
        if (!(material.as<WeaklyCompressibleFluid::Parameters>().viscosity > 0)) continue;
        const bool applied =
            std::any_of(model.dynamics.begin(), model.dynamics.end(), [&](const Component& method) {
                return method.declaration->name() == "fluid.viscous_force" &&
                       method.as<fluid::ViscousForceParameters>().body.text == body.name;
            });
        if (!applied)
            diagnostics.warning(material.placeOf("viscosity"),
                                fmt::format("nothing applies the viscosity of {}: there is no "
                                            "fluid.viscous_force for it",
                                            body.name));
    }
}

}  // namespace sphinx::model
