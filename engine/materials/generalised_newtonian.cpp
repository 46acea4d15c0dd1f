// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/generalised_newtonian.h"

#include "materials/declare_fluid.h"

namespace sphinx::materials {
namespace {

using input::number;

/// With what all of them have.
template <class Law, class P>
input::Declared<P>& declareLaw(input::Registry& registry, const char* name) {
    auto& d = declareFluidBase<P>(registry, name);
    d.trait("generalised_newtonian");
    d.required("power_law_index", &P::power_law_index, number(unit::none).above(0),
               "exponent n of the shear rate in the stress: below 1 it thins, above 1 it thickens");
    d.builder(MaterialBuilder{[](const void* p) -> std::shared_ptr<const Material> {
        return std::make_shared<Law>(*static_cast<const P*>(p));
    }});
    return d;
}

template <class P>
void declareConsistency(input::Declared<P>& d) {
    d.required("consistency", &P::consistency, number(unit::dynamic_viscosity).above(0),
               "consistency k, the viscosity at the reference rate");
    d.optional(
        "reference_rate", &P::reference_rate, number(unit::frequency).above(0),
        "shear rate gamma_1; at 1, in the unit of time of the case, the consistency is the K "
        "of a stress K gamma^n in the units of the case");
}

void declarePowerLaw(input::Registry& registry) {
    using P = PowerLawParameters;
    auto& d = declareLaw<PowerLawFluid, P>(registry, "power_law_fluid");
    d.summary("Fluid whose viscosity is a power of the shear rate (Ostwald-de Waele)");
    d.formula(
        "mu = k ((gamma^2 + gamma_0^2)/gamma_1^2)^((n - 1)/2), gamma = sqrt(2 D:D); p = c0^2 "
        "(rho - rho0)");
    d.cite("Bird, Armstrong & Hassager 1987");
    declareConsistency(d);
    d.required("regularisation_rate", &P::regularisation_rate, number(unit::frequency).above(0),
               "shear rate gamma_0, small against those of the flow, below which the viscosity "
               "stays what it is; for n < 1 that is the largest one, which decides on the time "
               "step");
}

void declareCarreau(input::Registry& registry) {
    using P = CarreauParameters;
    auto& d = declareLaw<CarreauFluid, P>(registry, "carreau_fluid");
    d.summary("Fluid whose viscosity goes from one value at rest to another at large shear rates");
    d.formula(
        "mu = mu_inf + (mu_0 - mu_inf) (1 + (lambda gamma)^2)^((n - 1)/2), gamma = sqrt(2 "
        "D:D); p = c0^2 (rho - rho0)");
    d.cite("Carreau 1972");
    d.required("zero_shear_viscosity", &P::zero_shear_viscosity,
               number(unit::dynamic_viscosity).above(0), "viscosity at rest, mu_0");
    d.required("infinite_shear_viscosity", &P::infinite_shear_viscosity,
               number(unit::dynamic_viscosity).atLeast(0),
               "viscosity at infinite shear rate, mu_inf");
    d.required("relaxation_time", &P::relaxation_time, number(unit::time).above(0),
               "lambda, one over the shear rate at which the viscosity leaves that at rest");
}

void declareHerschelBulkley(input::Registry& registry) {
    using P = HerschelBulkleyParameters;
    auto& d = declareLaw<HerschelBulkleyFluid, P>(registry, "herschel_bulkley_fluid");
    d.summary("Fluid that flows only under more than its yield stress; with n = 1 that of Bingham");
    d.formula(
        "mu = tau_y (1 - exp(-gamma/gamma_0))/gamma + k ((gamma^2 + gamma_0^2)/gamma_1^2)^((n "
        "- 1)/2), gamma = sqrt(2 D:D); p = c0^2 (rho - rho0)");
    d.cite("Papanastasiou 1987", "with m = 1/gamma_0");
    d.required("yield_stress", &P::yield_stress, number(unit::pressure).above(0),
               "yield stress tau_y");
    declareConsistency(d);
    d.optional("regularisation_rate", &P::regularisation_rate, number(unit::frequency).above(0),
               "shear rate gamma_0 below which it is a liquid as thick as tau_y/gamma_0, which "
               "decides on the time step; default: 0.01 of the rate at which k (gamma/gamma_1)^n "
               "gamma_1 is tau_y");
}

}  // namespace

void declareGeneralisedNewtonian(input::Registry& registry) {
    declarePowerLaw(registry);
    declareCarreau(registry);
    declareHerschelBulkley(registry);
}

}  // namespace sphinx::materials
