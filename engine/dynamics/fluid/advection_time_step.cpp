// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/advection_time_step.h"

#include "dynamics/fluid/largest_speed.h"
#include "materials/fluid.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::fluid {

template <int Dim>
AdvectionTimeStep<Dim>::AdvectionTimeStep(Body<Dim>& body, double reference_speed, double cfl)
    : body_(&body),
      reference_speed_(reference_speed),
      cfl_(cfl),
      velocity_(body.particles.vector(fields::velocity)) {
    const materials::Fluid& fluid = *body.fluid().material;
    nu_ = fluid.viscosity() / fluid.density();
}

template <int Dim>
double AdvectionTimeStep<Dim>::estimate() {
    const double speed2 = largestSquaredSpeed<Dim>(velocity_);
    const double h = body_->kernel.smoothingLength();
    const double step = h / std::max(std::sqrt(speed2), reference_speed_);
    return cfl_ * (nu_ > 0 ? std::min(step, h * h / nu_) : step);
}

void declareAdvectionTimeStep(input::Registry& registry) {
    using P = AdvectionTimeStepParameters;
    auto& d = declareTimeStep<P>(registry, "fluid.advection_time_step",
                                 []<int Dim>(const P& p, Context<Dim>& context) {
                                     return std::make_unique<AdvectionTimeStep<Dim>>(
                                         bodyOf(context, p.body), p.reference_speed, p.cfl);
                                 });
    d.summary("Time step by advection and viscosity");
    d.formula("guide (52): cfl min(h / max(abs(v)_max, reference_speed), h^2 / nu)");
    d.cite("guide", "(52)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.required("reference_speed", &P::reference_speed, input::number(unit::velocity).above(0),
               "typical speed of the flow; keeps the step finite while the fluid is at rest");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1), "factor");
    d.timeStep("").reads("body", {"velocity"});
}

template class AdvectionTimeStep<2>;
template class AdvectionTimeStep<3>;

}  // namespace sphinx::dynamics::fluid
