// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/acoustic_time_step.h"

#include "dynamics/fluid/largest_speed.h"
#include "materials/fluid.h"

#include <cmath>

namespace sphinx::dynamics::fluid {

template <int Dim>
AcousticTimeStep<Dim>::AcousticTimeStep(Body<Dim>& body, double cfl)
    : body_(&body),
      cfl_(cfl),
      c0_(body.fluid().material->soundSpeed()),
      velocity_(body.particles.vector(fields::velocity)) {}

template <int Dim>
double AcousticTimeStep<Dim>::estimate() {
    const double speed2 = largestSquaredSpeed<Dim>(velocity_);
    return cfl_ * body_->kernel.smoothingLength() / (c0_ + std::sqrt(speed2));
}

void declareAcousticTimeStep(input::Registry& registry) {
    using P = AcousticTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "fluid.acoustic_time_step", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<AcousticTimeStep<Dim>>(bodyOf(context, p.body), p.cfl);
        });
    d.summary("Time step by the speed of sound");
    d.formula("guide (53): cfl h / (c0 + abs(v)_max)");
    d.cite("guide", "(53)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1), "factor");
    d.timeStep("").reads("body", {"velocity"});
}

template class AcousticTimeStep<2>;
template class AcousticTimeStep<3>;

}  // namespace sphinx::dynamics::fluid
