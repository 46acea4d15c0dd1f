// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/builder.h"

namespace sphinx::fsi {

struct AverageKinematicsParameters {
    input::Name body;
};

/// Motion of an elastic body as its fluid sees it: velocity and acceleration averaged over one step
/// of the fluid, in which the solid makes several. begin notes positions and velocities, end divides
/// their change by the time between.
template <int Dim>
class AverageKinematics final : public Method {
   public:
    explicit AverageKinematics(Body<Dim>& body);
    void run(int action, const Clock& clock) override;
    std::size_t workSize() const override { return body_->size(); }

   private:
    Body<Dim>* body_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& average_velocity_;
    Field<Vec<Dim>>& average_acceleration_;
    AlignedVector<Vec<Dim>> old_position_;
    AlignedVector<Vec<Dim>> old_velocity_;
};

/// Registers fsi.average_kinematics.
void declareAverageKinematics(input::Registry& registry);

extern template class AverageKinematics<2>;
extern template class AverageKinematics<3>;

}  // namespace sphinx::fsi
