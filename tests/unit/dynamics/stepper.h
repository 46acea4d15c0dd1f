// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/solid/linear_correction.h"
#include "dynamics/solid/stress_relaxation.h"
#include "elastic.h"

namespace sphinx::test {

/// Steps one elastic body as a loop of its case would.
template <int Dim>
struct Stepper {
    Body<Dim>& body;
    solid::LinearCorrection<Dim> correction;
    solid::StressRelaxation<Dim> relaxation;
    Clock clock;

    Stepper(Context<Dim>& context, Body<Dim>& stepped)
        : body(stepped), correction(context, stepped), relaxation(context, stepped, true, true) {
        start();
    }
    void start() { correction.run(0, clock); }
    void step(double dt, const std::vector<Method*>& loads,
              const std::vector<Method*>& constraints = {}) {
        clock.dt = dt;
        body.particles.vector(fields::external_acceleration).setZero();
        for (Method* load : loads) load->run(0, clock);
        relaxation.run(0, clock);
        for (Method* constraint : constraints) constraint->run(0, clock);
        relaxation.run(1, clock);
        clock.time += dt;
        ++clock.steps;
    }
};

}  // namespace sphinx::test
