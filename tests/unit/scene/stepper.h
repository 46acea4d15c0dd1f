// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/shares.h"
#include "dynamics/solid/linear_correction.h"
#include "dynamics/solid/stress_relaxation.h"
#include "scene.h"

#include <functional>
#include <vector>

namespace sphinx::test {

/// A line of a loop that calls the only action of a method.
class Line {
 public:
    template <class M>
    Line(M* method) : run_([method](const Clock& clock) { method->run(clock); }) {}
    void operator()(const Clock& clock) const { run_(clock); }

 private:
    std::function<void(const Clock&)> run_;
};

/// Steps one elastic body as a loop of its case would.
template <int Dim>
struct Stepper {
    bodies::Body<Dim>& body;
    dynamics::solid::LinearCorrection<Dim> correction;
    dynamics::solid::StressRelaxation<Dim> relaxation;
    Clock clock;

    /// `others`: those besides that have to announce themselves or to be prepared.
    Stepper(Scene<Dim>& scene, bodies::Body<Dim>& stepped,
            std::vector<dynamics::Method*> others = {})
        : body(stepped),
          correction(scene.context, stepped),
          relaxation(scene.context, stepped, true, true) {
        others.insert(others.end(), {&correction, &relaxation});
        for (dynamics::Method* method : others) method->announce();
        bodies::findShares(body);
        for (dynamics::Method* method : others) method->prepare();
        start();
    }
    void start() { correction.run({.is_start = true}); }
    void step(double dt, const std::vector<Line>& loads,
              const std::vector<Line>& constraints = {}) {
        clock.dt = dt;
        body.particles.vector(fields::external_acceleration).setZero();
        for (const Line& load : loads) load(clock);
        relaxation.firstHalf(clock);
        for (const Line& constraint : constraints) constraint(clock);
        relaxation.secondHalf(clock);
        clock.time += dt;
        ++clock.steps;
    }
};

}  // namespace sphinx::test
