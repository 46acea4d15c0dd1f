// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "particles/side_array.h"

namespace sphinx::dynamics::fsi {

struct AverageKinematicsParameters {
    input::Name body;
};

/// Motion of an elastic body as its fluid sees it. Over one step of the fluid, in which the solid
/// makes several: the mean velocity u, its change since the step before as acceleration, and as
/// velocity u carried on to the end of the step, where the fluid uses it. (A fluid that sees the
/// velocity of half a step ago is a spring that pushes late: it feeds the plate's motion.) The
/// steps of the solid belong before the second half of the fluid's pressure relaxation.
///
/// Modes of a stiff plate that swing more than half a time in a step of the fluid radiate at
/// another frequency than their own, and swing up. Kelvin-Voigt damping holds them, or a smaller
/// `cfl` of the fluid's step (measured: cases/hydrostatic_plate_fsi_2d/README.md).
template <int Dim>
class AverageKinematics final : public Method {
 public:
    explicit AverageKinematics(Body<Dim>& body);
    void begin(const Clock&);
    void end(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }
    void transfer(Archive& archive) override;

 private:
    Body<Dim>* body_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& average_velocity_;
    Field<Vec<Dim>>& average_acceleration_;
    sphinx::particles::SideArray<Vec<Dim>>
        old_position_;  // at `begin`, or where a particle came since
    double last_dt_ = 0;
};

/// Registers fsi.average_kinematics.
void declareAverageKinematics(input::Registry& registry);

}  // namespace sphinx::dynamics::fsi
