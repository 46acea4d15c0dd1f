// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/largest_speed.h"
#include "dynamics/methods.h"
#include "materials/fluid.h"

#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

/// Acoustic criterion, guide (53): CFL h / (c0 + abs(v)_max).
struct AcousticTimeStepParameters {
    input::Name body;
    double cfl = 0.6;
};

}  // namespace

void declareAcousticTimeStep(input::Registry& registry) {
    using P = AcousticTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "fluid.acoustic_time_step", []<int Dim>(const P& p, Body<Dim>& body) {
            const double c0 = body.fluid().material->soundSpeed();
            return [&, cfl = p.cfl, c0] {
                const double speed2 = largestSquaredSpeed(body);
                return cfl * body.kernel.smoothingLength() / (c0 + std::sqrt(speed2));
            };
        });
    d.summary("Time step by the speed of sound");
    d.formula("guide (53): cfl h / (c0 + abs(v)_max)");
    d.cite("guide", "(53)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1), "factor");
    d.timeStep("").reads("body", {"velocity"});
}

}  // namespace sphinx::dynamics::fluid
