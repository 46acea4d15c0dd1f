// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/solid/deformation.h"

namespace sphinx::dynamics::solid {

struct StressRelaxationParameters {
    input::Name body;
    bool hourglass_control = true;
    bool damping = true;
};

/// Elastic step of a total-Lagrangian solid, guide (5), as drift-kick-drift:
///   first half:  F += dt/2 dF, r += dt/2 v, P(F), then
///                dv_i = V_i/m_i sum_j (P_i B_i^T + P_j B_j^T) e_ij W' V_j + external,  v += dt dv
///                (with the hourglass control and the shares of particles, see Deformation)
///   second half: dF_i = -sum_j v_ij (x) e_ij W' V_j B_i,  F += dt/2 dF, r += dt/2 v
/// all sums in the reference configuration. External are the accumulated accelerations and the
/// forces of fluids by pressure and viscosity. A constraint acts between the halves.
template <int Dim>
class StressRelaxation final : public Method {
 public:
    StressRelaxation(Context<Dim>& context, Body<Dim>& body, bool hourglass_control, bool damping);
    void announce() override { deformation_.announce(); }
    void prepare() override { deformation_.prepare(); }
    std::size_t workSize() const override { return body_->size(); }

    void firstHalf(const Clock& clock);
    void secondHalf(const Clock& clock);

 private:
    Body<Dim>* body_;
    Deformation<Dim> deformation_;
    bool damping_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& acceleration_;
    Field<Vec<Dim>>& external_;
    Field<Vec<Dim>>& pressure_force_;
    Field<Vec<Dim>>& viscous_force_;
    Field<double>& mass_;
    Field<double>& volume_;
};

/// Registers solid.stress_relaxation.
void declareStressRelaxation(input::Registry& registry);

}  // namespace sphinx::dynamics::solid
