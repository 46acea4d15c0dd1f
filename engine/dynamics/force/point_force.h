// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/known_load.h"

namespace sphinx::dynamics::force {

struct PointForceParameters {
    input::Name part;
    std::vector<input::FieldExpression> force;
};

/// One force on a part of an elastic body, shared by its particles as their masses are, so that
/// each gets the acceleration F/M and the sum is exactly F. Evaluated at the middle of the step,
/// where the velocity gets its kick.
template <int Dim>
class PointForce final : public Method, public AppliedLoad<Dim> {
 public:
    PointForce(Part<Dim> part, std::vector<input::FieldExpression> force);

    void run(const Clock& clock);
    std::size_t workSize() const override { return part_.size(); }
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }

 private:
    Part<Dim> part_;
    std::vector<input::FieldExpression> force_;
    Field<Vec<Dim>>& velocity_;
    Field<double>& mass_;
    Field<Vec<Dim>>& external_;
};

/// Registers force.point_force.
void declarePointForce(input::Registry& registry);

}  // namespace sphinx::dynamics::force
