// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/shares.h"
#include "scene.h"

#include <vector>

namespace sphinx::test {

/// Steps one elastic body as a loop of its case would.
template <int Dim>
struct Stepper {
    bodies::Body<Dim>& body;
    MadeMethod<Dim> correction;
    MadeMethod<Dim> relaxation;
    Clock clock;

    /// `others`: those besides that have to announce themselves or to be prepared.
    Stepper(Scene<Dim>& scene, bodies::Body<Dim>& stepped,
            std::vector<const MadeMethod<Dim>*> others = {})
        : body(stepped),
          correction(scene.method("type: solid.linear_correction, body: " + stepped.name)),
          relaxation(scene.method("type: solid.stress_relaxation, body: " + stepped.name)) {
        others.insert(others.end(), {&correction, &relaxation});
        for (const MadeMethod<Dim>* method : others) (*method)->announce();
        bodies::findShares(body);
        for (const MadeMethod<Dim>* method : others) (*method)->prepare();
        start();
    }
    void start() { correction.run({.is_start = true}); }
    void step(double dt, const std::vector<const MadeMethod<Dim>*>& loads,
              const std::vector<const MadeMethod<Dim>*>& constraints = {}) {
        clock.dt = dt;
        body.particles.vector(fields::external_acceleration).setZero();
        for (const MadeMethod<Dim>* load : loads) load->run(clock);
        relaxation.run(clock, "first_half");
        for (const MadeMethod<Dim>* constraint : constraints) constraint->run(clock);
        relaxation.run(clock, "second_half");
        clock.time += dt;
        ++clock.steps;
    }
};

}  // namespace sphinx::test
