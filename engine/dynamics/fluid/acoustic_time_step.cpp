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

/// Acoustic criterion, guide (53): CFL h / (c0 + abs(v)_max).
///
/// The default is 0.95 of the largest stable factor on a lattice, the smallest over the customary
/// ratios: 2D 0.727, quintic spline 0.927; 3D 0.630, quintic spline 0.815. From the eigenvalues of
/// a step over all wave numbers, with the jumps of the Riemann problem, which are what limits it;
/// acoustic_step.md has the equations, and experiments with walls, disorder and flows.
///
/// An elastic body that the force of fluid.implicit_viscosity pushes gets it explicitly: in a step
/// its surface, were it free, follows the fluid that much of the way, at most all of it.
struct AcousticTimeStepParameters {
    input::Name body;
    std::optional<double> cfl;
};

double acousticCfl(kernels::KernelType kernel, int dimension) {
    const bool quintic = kernel == kernels::KernelType::quintic_spline;
    if (dimension == 2) return quintic ? 0.88 : 0.69;
    return quintic ? 0.78 : 0.6;
}

}  // namespace

void declareAcousticTimeStep(input::Registry& registry) {
    using P = AcousticTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "fluid.acoustic_time_step", []<int Dim>(const P& p, Body<Dim>& body) {
            const double c0 = body.fluid().material->soundSpeed();
            return [&, cfl = p.cfl.value_or(acousticCfl(body.kernel.type(), Dim)), c0] {
                const double speed2 = largestSquaredSpeed(body);
                const double step = cfl * body.kernel.smoothingLength() / (c0 + std::sqrt(speed2));
                const double rate = body.fluid().viscous.implicitRate();
                return rate > 0 ? std::min(step, 1 / rate) : step;
            };
        });
    d.summary("Time step by the speed of sound");
    d.formula(
        "guide (53): cfl h / (c0 + abs(v)_max); where fluid.implicit_viscosity drags elastic "
        "bodies, no more than 1 / lambda_w, the largest rate at which it changes the velocity of a "
        "particle of the lightest of them");
    d.cite("guide", "(53)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional(
        "cfl", &P::cfl, input::number(unit::none).above(0).atMost(1),
        "factor; default, 0.95 of what is stable on a lattice: 0.69 in 2D and 0.6 in 3D, with "
        "quintic_spline, whose h is the smaller, 0.88 and 0.78");
    d.timeStep("").reads("body", {"velocity"});
}

}  // namespace sphinx::dynamics::fluid
