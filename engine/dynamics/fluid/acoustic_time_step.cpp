// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/largest.h"
#include "dynamics/methods.h"
#include "materials/fluid.h"

#include <cmath>
#include <optional>

namespace sphinx::dynamics::fluid {
namespace {

/// Acoustic criterion, guide (53): CFL h / (c0 + abs(v)_max).
///
/// The default is 0.95 of the largest stable factor on a cubic lattice: 0.62 for Wendland C2 at h =
/// 1.3 to 1.7 dp, 0.82 for the quintic spline at 1 to 1.1, 0.66 for the cubic at 1.3 (in 2D 0.74 to
/// 0.78, 0.97, 0.80). From the eigenvalues of a step, in two halves around the momentum sum with
/// the velocity jump of the Riemann problem, over all wave numbers.
struct AcousticTimeStepParameters {
    input::Name body;
    std::optional<double> cfl;
};

double acousticCfl(kernels::KernelType kernel) {
    return kernel == kernels::KernelType::quintic_spline ? 0.78 : 0.6;
}

}  // namespace

void declareAcousticTimeStep(input::Registry& registry) {
    using P = AcousticTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "fluid.acoustic_time_step", []<int Dim>(const P& p, Body<Dim>& body) {
            const double c0 = body.fluid().material->soundSpeed();
            return [&, cfl = p.cfl.value_or(acousticCfl(body.kernel.type())), c0] {
                const double speed2 = largestSquaredSpeed(body);
                return cfl * body.kernel.smoothingLength() / (c0 + std::sqrt(speed2));
            };
        });
    d.summary("Time step by the speed of sound");
    d.formula("guide (53): cfl h / (c0 + abs(v)_max)");
    d.cite("guide", "(53)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1),
               "factor; default: 0.6, with quintic_spline 0.78, whose h is the smaller");
    d.timeStep("").reads("body", {"velocity"});
}

}  // namespace sphinx::dynamics::fluid
