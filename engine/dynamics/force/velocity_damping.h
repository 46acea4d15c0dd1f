// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::force {

struct VelocityDampingParameters {
    input::Name body;
    double rate = 0;  ///< 1/time
};

/// Drag in proportion to mass and velocity, dv/dt = -rate v, by its solution over the substep of
/// its layer, v *= exp(-rate dt): stable at any step. It brings a body to rest where the final
/// state, not the way to it, is asked for; a mode of the frequency omega is damped fastest at rate
/// = 2 omega.
template <int Dim>
class VelocityDamping final : public Method {
 public:
    VelocityDamping(Body<Dim>& body, double rate);

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    double rate_;
    Field<Vec<Dim>>& velocity_;
};

/// Registers force.velocity_damping.
void declareVelocityDamping(input::Registry& registry);

}  // namespace sphinx::dynamics::force
