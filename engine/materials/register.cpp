// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/register.h"

#include "materials/fluid.h"

namespace sphinx {
namespace {

struct RigidParameters {
    double density = 1;
};

template <class P, class Law>
MaterialFactory factory() {
    return [](const void* p) -> std::shared_ptr<const Material> {
        return std::make_shared<Law>(*static_cast<const P*>(p));
    };
}

void declareRigid(input::Registry& registry) {
    using P = RigidParameters;
    auto& d = registry.declare<P>(input::Kind::material, "rigid");
    d.summary("Does not deform: walls and obstacles");
    d.trait("rigid");
    d.optional("density", &P::density, input::number(unit::density).above(0), "density");
    d.builder(MaterialFactory([](const void* p) -> std::shared_ptr<const Material> {
        return std::make_shared<Rigid>(static_cast<const P*>(p)->density);
    }));
}

void declareWeaklyCompressibleFluid(input::Registry& registry) {
    using P = WeaklyCompressibleFluid::Parameters;
    auto& d = registry.declare<P>(input::Kind::material, "weakly_compressible_fluid");
    d.summary("Fluid whose pressure follows from its density; for flows slow against its sound");
    d.formula("linear: p = c0^2 (rho - rho0); tait: p = rho0 c0^2/gamma ((rho/rho0)^gamma - 1)");
    d.citation("guide below (19); Monaghan 1994, doi:10.1006/jcph.1994.1034");
    d.trait("fluid");
    d.required("density", &P::density, input::number(unit::density).above(0),
               "density at zero pressure, rho0");
    d.required("sound_speed", &P::sound_speed, input::number(unit::velocity).above(0),
               "speed of sound c0, at least ten times the largest speed of the flow");
    d.optional("viscosity", &P::viscosity, input::number(unit::dynamic_viscosity).atLeast(0),
               "dynamic viscosity mu");
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
    d.builder(factory<P, WeaklyCompressibleFluid>());
}

}  // namespace

void registerMaterials(input::Registry& registry) {
    declareRigid(registry);
    declareWeaklyCompressibleFluid(registry);
    registerElasticSolids(registry);
}

}  // namespace sphinx
