// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "materials/law_list.h"
#include "materials/linear_pressure.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sphinx::materials {

/// Fluid whose viscosity depends on the shear rate gamma = sqrt(2 D:D), 1/time. How is a member of
/// the final classes, reached through withViscosity():
///
///     double viscosityAt(double shear_rate) const;  // above 0, also at rest
class GeneralisedNewtonianFluid : public LinearPressure {
 public:
    using LinearPressure::LinearPressure;
};

struct PowerLawParameters {
    double density = 0;      ///< rho0, mass/length^3
    double sound_speed = 0;  ///< c0, length/time
    double consistency = 0;  ///< viscosity at the reference rate, mass/(length time)
    double power_law_index = 1;
    double reference_rate = 1;       ///< gamma_1, 1/time
    double regularisation_rate = 0;  ///< gamma_0, 1/time
};

/// Ostwald-de Waele: mu = k ((gamma^2 + gamma_0^2)/gamma_1^2)^((n - 1)/2). The power of gamma alone
/// is infinite at rest for n < 1, and zero for n > 1; the stress is off by (n - 1)/2
/// (gamma_0/gamma)^2.
class PowerLawFluid final : public GeneralisedNewtonianFluid {
 public:
    explicit PowerLawFluid(const PowerLawParameters& p)
        : GeneralisedNewtonianFluid(p.density, p.sound_speed, of(p, 0)), p_(p) {}
    double viscosityAt(double shear_rate) const { return of(p_, shear_rate); }

 private:
    static double of(const PowerLawParameters& p, double rate) {
        return p.consistency * std::pow(std::hypot(rate, p.regularisation_rate) / p.reference_rate,
                                        p.power_law_index - 1);
    }
    PowerLawParameters p_;
};

struct CarreauParameters {
    double density = 0;
    double sound_speed = 0;
    double zero_shear_viscosity = 0;
    double infinite_shear_viscosity = 0;
    double relaxation_time = 0;
    double power_law_index = 1;
};

/// mu = mu_inf + (mu_0 - mu_inf) (1 + (lambda gamma)^2)^((n - 1)/2), Carreau 1972.
class CarreauFluid final : public GeneralisedNewtonianFluid {
 public:
    explicit CarreauFluid(const CarreauParameters& p)
        : GeneralisedNewtonianFluid(p.density, p.sound_speed, p.zero_shear_viscosity), p_(p) {}
    double viscosityAt(double shear_rate) const {
        const double rate = p_.relaxation_time * shear_rate;
        return p_.infinite_shear_viscosity +
               (p_.zero_shear_viscosity - p_.infinite_shear_viscosity) *
                   std::pow(1 + rate * rate, 0.5 * (p_.power_law_index - 1));
    }

 private:
    CarreauParameters p_;
};

struct HerschelBulkleyParameters {
    double density = 0;
    double sound_speed = 0;
    double yield_stress = 0;  ///< mass/(length time^2)
    double consistency = 0;   ///< of viscosity, at the reference rate
    double power_law_index = 1;
    double reference_rate = 1;                  ///< gamma_1
    std::optional<double> regularisation_rate;  ///< gamma_0; without: a hundredth of yieldRate()

    /// At which the yield stress is as large as the stress that the rate adds to it.
    double yieldRate() const {
        return reference_rate *
               std::pow(yield_stress / (consistency * reference_rate), 1 / power_law_index);
    }
};

/// mu = tau_y (1 - exp(-gamma/gamma_0))/gamma + k ((gamma^2 + gamma_0^2)/gamma_1^2)^((n - 1)/2),
/// Papanastasiou 1987, doi:10.1122/1.549926, with m = 1/gamma_0: what has not yielded is a liquid
/// as thick as tau_y/gamma_0.
class HerschelBulkleyFluid final : public GeneralisedNewtonianFluid {
 public:
    explicit HerschelBulkleyFluid(const HerschelBulkleyParameters& p)
        : GeneralisedNewtonianFluid(p.density, p.sound_speed, of(p, 0)), p_(p) {}
    double viscosityAt(double shear_rate) const { return of(p_, shear_rate); }

 private:
    static double of(const HerschelBulkleyParameters& p, double rate) {
        const double least = p.regularisation_rate.value_or(0.01 * p.yieldRate());
        const double x = std::max(rate / least, 1e-12);
        return p.yield_stress / least * (-std::expm1(-x) / x) +
               p.consistency *
                   std::pow(std::hypot(rate, least) / p.reference_rate, p.power_law_index - 1);
    }
    HerschelBulkleyParameters p_;
};

using GeneralisedNewtonianLaws = LawList<PowerLawFluid, CarreauFluid, HerschelBulkleyFluid>;

/// withViscosity(fluid, [&](const auto& law) { ... law.viscosityAt(shear_rate) ... });
template <class F>
decltype(auto) withViscosity(const GeneralisedNewtonianFluid& fluid, F&& f) {
    return visitLaw(GeneralisedNewtonianLaws{}, fluid, std::forward<F>(f));
}

/// nullptr where the viscosity is the same at every rate.
inline const GeneralisedNewtonianFluid* asGeneralisedNewtonian(const Fluid& fluid) {
    return dynamic_cast<const GeneralisedNewtonianFluid*>(&fluid);
}

/// Registers power_law_fluid, carreau_fluid and herschel_bulkley_fluid.
void declareGeneralisedNewtonian(input::Registry& registry);

}  // namespace sphinx::materials
