// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::fluid {

struct AcousticTimeStepParameters {
    input::Name body;
    double cfl = 0.6;
};

/// Acoustic criterion, guide (53): CFL h / (c0 + abs(v)_max).
template <int Dim>
class AcousticTimeStep final : public TimeStepMethod {
 public:
    AcousticTimeStep(Body<Dim>& body, double cfl);

    double estimate() override;
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    double cfl_;
    double c0_;
    Field<Vec<Dim>>& velocity_;
};

/// Registers fluid.acoustic_time_step.
void declareAcousticTimeStep(input::Registry& registry);

}  // namespace sphinx::dynamics::fluid
