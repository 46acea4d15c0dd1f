// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::force {

struct BodyForceParameters {
    input::Name body;
    std::vector<input::FieldExpression> acceleration;
};

/// Force per mass given as expressions of place and time, evaluated at the start of a substep of
/// its layer.
template <int Dim>
class BodyForce final : public Method {
 public:
    BodyForce(Body<Dim>& body, std::vector<input::FieldExpression> acceleration);

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    std::vector<input::FieldExpression> acceleration_;
    Field<Vec<Dim>>& external_;
};

/// Registers force.body_force.
void declareBodyForce(input::Registry& registry);

}  // namespace sphinx::dynamics::force
