// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

namespace sphinx::dynamics::force {

struct GravityParameters {
    input::Name body;
    input::Coordinates acceleration;
};

/// Uniform gravity. The body knows it from the start: the potential energy and the pressure step
/// of a resting fluid use it, so it acts throughout.
template <int Dim>
class Gravity final : public Method {
 public:
    Gravity(Body<Dim>& body, const Vec<Dim>& acceleration);

    void announce() override { body_->addGravity(acceleration_); }
    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    Vec<Dim> acceleration_;
    Field<Vec<Dim>>& external_;
};

/// Registers force.gravity.
void declareGravity(input::Registry& registry);

}  // namespace sphinx::dynamics::force
