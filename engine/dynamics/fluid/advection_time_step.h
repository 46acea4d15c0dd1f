// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::fluid {

struct AdvectionTimeStepParameters {
    input::Name body;
    double reference_speed = 0;
    double cfl = 0.25;
};

/// Advection criterion, guide (52): CFL min(h / max(abs(v)_max, v_ref), h^2 / nu).
template <int Dim>
class AdvectionTimeStep final : public TimeStepMethod {
 public:
    /// reference_speed: velocity, keeps the step finite while the fluid is at rest.
    AdvectionTimeStep(Body<Dim>& body, double reference_speed, double cfl);

    double estimate() override;
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    double reference_speed_;
    double cfl_;
    double nu_;  // kinematic viscosity
    Field<Vec<Dim>>& velocity_;
};

/// Registers fluid.advection_time_step.
void declareAdvectionTimeStep(input::Registry& registry);

}  // namespace sphinx::dynamics::fluid
