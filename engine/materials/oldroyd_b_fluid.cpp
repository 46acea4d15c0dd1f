// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/oldroyd_b_fluid.h"

#include "materials/declare_fluid.h"

namespace sphinx::materials {

void declareOldroydB(input::Registry& registry) {
    using P = OldroydBParameters;
    auto& d = declareFluidBase<P>(registry, "oldroyd_b_fluid");
    d.trait("viscoelastic");
    d.summary("Newtonian solvent with dissolved polymers, which stretch and relax (Oldroyd-B)");
    d.formula(
        "tau = 2 eta_s D + tau_p, lambda (dtau_p/dt - L tau_p - tau_p L^T) + tau_p = 2 eta_p D; "
        "p = c0^2 (rho - rho0)");
    d.cite("guide", "(20)").cite("Oldroyd 1950");
    d.required("solvent_viscosity", &P::solvent_viscosity,
               input::number(unit::dynamic_viscosity).atLeast(0),
               "viscosity eta_s of the solvent, which fluid.viscous_force applies");
    d.required("polymer_viscosity", &P::polymer_viscosity,
               input::number(unit::dynamic_viscosity).above(0),
               "what the polymers add to the viscosity of a steady shear flow, eta_p");
    d.required("relaxation_time", &P::relaxation_time, input::number(unit::time).above(0),
               "time lambda in which the stress of the polymers goes down to 1/e");
    d.builder(MaterialBuilder{[](const void* p) -> std::shared_ptr<const Material> {
        return std::make_shared<OldroydBFluid>(*static_cast<const P*>(p));
    }});
}

}  // namespace sphinx::materials
