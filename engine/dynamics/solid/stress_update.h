// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/solid/deformation.h"

namespace sphinx::dynamics::solid {

struct StressUpdateParameters {
    input::Name body;
    bool hourglass_control = true;
};

/// Deformation and stress of an elastic body whose particles are held, in two halves around the
/// step of a body that is bonded to it: guide, chapter 5, the base of the gate. Nothing moves.
template <int Dim>
class StressUpdate final : public Method {
 public:
    StressUpdate(Context<Dim>& context, Body<Dim>& body, bool hourglass_control)
        : deformation_(context, body, hourglass_control) {}
    void announce() override { deformation_.announce(); }
    void prepare() override { deformation_.prepare(); }
    void firstHalf(const Clock& clock) { deformation_.firstHalf(clock); }
    void secondHalf(const Clock& clock) { deformation_.secondHalf(clock.dt); }
    std::size_t workSize() const override { return deformation_.body().size(); }

 private:
    Deformation<Dim> deformation_;
};

/// Registers solid.stress_update.
void declareStressUpdate(input::Registry& registry);

}  // namespace sphinx::dynamics::solid
