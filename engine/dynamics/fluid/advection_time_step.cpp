// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/largest.h"
#include "dynamics/methods.h"
#include "materials/fluid.h"

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
struct AdvectionTimeStepParameters {
    input::Name body;
    double reference_speed = 0;  ///< velocity; keeps the step finite while the fluid is at rest
    std::optional<double> cfl;
};

/// A third of a spacing with the kernels' customary smoothing lengths.
double advectionCfl(kernels::KernelType kernel) {
    return kernel == kernels::KernelType::quintic_spline ? 0.325 : 0.25;
}

}  // namespace

void declareAdvectionTimeStep(input::Registry& registry) {
    using P = AdvectionTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "fluid.advection_time_step", []<int Dim>(const P& p, Body<Dim>& body) {
            const materials::Fluid& fluid = *body.fluid().material;
            const double nu = fluid.viscosity() / fluid.density();
            const double cfl = p.cfl.value_or(advectionCfl(body.kernel.type()));
            return [&, p, nu, cfl] {
                const double speed2 =
                    std::max(largestSquaredSpeed(body),
                             2 * largestPressure(body) / body.fluid().material->density());
                const double h = body.kernel.smoothingLength();
                const double step = h / std::max(std::sqrt(speed2), p.reference_speed);
                if (nu == 0) return cfl * step;
                const double rate = body.fluid().viscous.rate(fluid.density());
                return std::min(cfl * std::min(step, h * h / nu), rate > 0 ? 2 / rate : step);
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
        "lighter than the fluid");
    d.cite("guide", "(52)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.required("reference_speed", &P::reference_speed, input::number(unit::velocity).above(0),
               "typical speed of the flow; keeps the step finite while the fluid is at rest");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1),
               "factor; default: 0.25, with quintic_spline 0.325, whose h is the smaller");
    d.timeStep("").reads("body", {"velocity", "pressure"});
}

}  // namespace sphinx::dynamics::fluid
