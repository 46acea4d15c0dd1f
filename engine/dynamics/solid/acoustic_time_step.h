// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "materials/elastic_solid.h"

namespace sphinx::dynamics::solid {

struct AcousticTimeStepParameters {
    input::Name body;
    double cfl = 0.6;
};

/// cfl min(h/(c + abs(v)), sqrt(h/abs(a))), c^2 = modulus / rho0 with the largest tangent modulus
/// of the present state; with Kelvin-Voigt damping eta also rho0 h^2 / (4 eta).
template <int Dim>
class AcousticTimeStep final : public TimeStepMethod {
 public:
    AcousticTimeStep(Body<Dim>& body, double cfl);
    double estimate() override;
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    const materials::ElasticSolid* solid_;
    double cfl_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& acceleration_;
    Field<Mat<Dim>>& gradient_;
};

/// Registers solid.acoustic_time_step.
void declareAcousticTimeStep(input::Registry& registry);

}  // namespace sphinx::dynamics::solid
