// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/weakly_compressible_fluid.h"

#include "materials/declare_fluid.h"

namespace sphinx::materials {

std::shared_ptr<const Fluid> makeFluid(const WeaklyCompressibleFluidParameters& p) {
    if (p.equation_of_state == EquationOfState::linear)
        return std::make_shared<LinearFluid>(p.density, p.sound_speed, p.viscosity);
    return std::make_shared<TaitFluid>(p.density, p.sound_speed, p.viscosity, p.gamma.value_or(7));
}

void declareWeaklyCompressibleFluid(input::Registry& registry) {
    using P = WeaklyCompressibleFluidParameters;
    auto& d = declareFluid<P>(registry, "weakly_compressible_fluid");
    d.summary("Fluid whose pressure follows from its density; for flows slow against its sound");
    d.formula("linear: p = c0^2 (rho - rho0); tait: p = rho0 c0^2/gamma ((rho/rho0)^gamma - 1)");
    d.cite("guide", "below (19)").cite("Monaghan 1994");
    d.optional("equation_of_state", &P::equation_of_state,
               input::choice<EquationOfState>({
                   {"linear", EquationOfState::linear, "p = c0^2 (rho - rho0)"},
                   {"tait", EquationOfState::tait, "p = rho0 c0^2/gamma ((rho/rho0)^gamma - 1)"},
               }),
               "pressure as a function of density");
    d.optional("gamma", &P::gamma, input::number(unit::none).above(1),
               "exponent of the tait equation; default: 7");
    d.check("gamma", [](const P& p) {
        return p.gamma && p.equation_of_state == EquationOfState::linear
                   ? "gamma is used by 'equation_of_state: tait' alone, here it is linear"
                   : "";
    });
    d.builder(MaterialBuilder{[](const void* p) -> std::shared_ptr<const Material> {
        return makeFluid(*static_cast<const P*>(p));
    }});
}

}  // namespace sphinx::materials
