// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/elastic_step.h"
#include "dynamics/fluid/largest.h"
#include "dynamics/methods.h"
#include "materials/generalised_newtonian.h"
#include "materials/oldroyd_b_fluid.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sphinx::dynamics::fluid {
namespace {

/// Advection criterion, guide (52): CFL min(h / max(abs(v)_max, v_ref), h^2 / nu).
/// - v_ref is at least the speed sqrt(2 abs(p)_max/rho0) to which the pressure could drive the
///   fluid. Between two advection steps the gradients of the kernel stay as they are: what a
///   displacement under pressure changes of the force acts late, like a spring with a lag, and
///   feeds noise at a rate that grows with p and with the step. free_surface.md has a tank.
/// - It is no more than 2 / lambda, beyond which the viscous force swings up whatever the factor.
///   lambda is the largest rate at which it changes velocities (viscous_bound.h).
/// - Where fluid.implicit_viscosity solves for the viscous force, neither that nor h^2/nu counts.
/// - Of polymers it is no more than half of what their stress bears (elastic_step.h); with the
///   viscous force, no more than makes both shares of their limits 1.
/// The viscosity of a generalised Newtonian fluid is the largest that the viscous force has found
/// last, and before it has, the larger one of that at rest and that at a shear of the reference
/// speed over h.
struct AdvectionTimeStepParameters {
    input::Name body;
    double reference_speed = 0;  ///< velocity; keeps the step finite while the fluid is at rest
    std::optional<double> cfl;
};

/// A third of a spacing with the kernels' customary smoothing lengths.
double advectionCfl(kernels::KernelType kernel) {
    return kernel == kernels::KernelType::quintic_spline ? 0.325 : 0.25;
}

template <int Dim>
double largestViscosity(const materials::GeneralisedNewtonianFluid& fluid, const Body<Dim>& body,
                        const Field<double>& viscosity, double rate) {
    const double largest = maxAll(body.size(), 0.0, [&](std::size_t i) { return viscosity[i]; });
    if (largest > 0) return largest;
    return materials::withViscosity(fluid, [&](const auto& law) {
        return std::max(law.viscosityAt(0), law.viscosityAt(rate));
    });
}

}  // namespace

void declareAdvectionTimeStep(input::Registry& registry) {
    using P = AdvectionTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "fluid.advection_time_step", []<int Dim>(const P& p, Body<Dim>& body) {
            const materials::Fluid& fluid = *body.fluid().material;
            const auto* varying = materials::asGeneralisedNewtonian(fluid);
            const auto* viscosity = varying ? &body.particles.scalar(fields::viscosity) : nullptr;
            const double cfl = p.cfl.value_or(advectionCfl(body.kernel.type()));
            const auto* polymers = materials::asOldroydB(fluid);
            const auto* conformation =
                polymers ? &body.particles.matrix(fields::conformation) : nullptr;
            const double gradient = polymers ? largestGradient<Dim>(body.kernel, body.spacing) : 0;
            return [&, p, varying, viscosity, polymers, conformation, gradient, cfl] {
                const double speed2 =
                    std::max(largestSquaredSpeed(body),
                             2 * largestPressure(body) / body.fluid().material->density());
                const double h = body.kernel.smoothingLength();
                const double step = h / std::max(std::sqrt(speed2), p.reference_speed);
                const double mu =
                    varying ? largestViscosity(*varying, body, *viscosity, p.reference_speed / h)
                            : fluid.viscosity();
                const double nu = mu / fluid.density();
                const bool viscous = nu > 0 && body.fluid().viscous.limitSteps();
                if (!viscous && !polymers) return cfl * step;
                double rate = viscous ? body.fluid().viscous.rate(fluid.density()) : 0;
                if (varying) rate *= mu / fluid.viscosity();
                if (polymers)
                    rate += 2 / elasticStep(*polymers, largestTrace(body, *conformation), gradient);
                const double flow = viscous ? std::min(step, h * h / nu) : step;
                return std::min(cfl * flow, rate > 0 ? 2 / rate : step);
            };
        });
    d.summary("Time step by advection and viscosity");
    d.formula(
        "guide (52): cfl min(h / max(abs(v)_max, sqrt(2 abs(p)_max/rho0), reference_speed), h^2 / "
        "nu); at most 2 / lambda, the largest rate at which the viscous force changes a velocity "
        "on "
        "a lattice: about mu/rho times twice the sum of its weights, those of walls with 1/rho_s "
        "in "
        "place of 1/rho for the lightest elastic body that fsi.viscous_force pushes, where it is "
        "lighter than the fluid; with polymers 2 / (lambda + 2/dt_e), dt_e their own limit, half "
        "of "
        "the step in which a wave of their tension crosses the gradient of the kernel; with "
        "fluid.implicit_viscosity neither h^2 / nu nor lambda counts");
    d.cite("guide", "(52)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.required("reference_speed", &P::reference_speed, input::number(unit::velocity).above(0),
               "typical speed of the flow; keeps the step finite while the fluid is at rest");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1),
               "factor; default: 0.25, with quintic_spline 0.325, whose h is the smaller");
    d.timeStep("")
        .reads("body", {"velocity", "pressure"})
        .mayRead("body.generalised_newtonian", {"viscosity"})
        .mayRead("body.viscoelastic", {"conformation"});
}

}  // namespace sphinx::dynamics::fluid
