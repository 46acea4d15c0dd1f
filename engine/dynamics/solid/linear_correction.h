// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/solid/deformation.h"

namespace sphinx::dynamics::solid {

struct LinearCorrectionParameters {
    input::Name body;
};

/// Correction matrix B_i of an elastic body, guide (30), and the deformation that its positions and
/// velocities have at the start.
template <int Dim>
class LinearCorrection final : public Method {
 public:
    LinearCorrection(Context<Dim>& context, Body<Dim>& body) : deformation_(context, body, false) {}
    void prepare() override { deformation_.prepare(); }
    void run(const Clock&) { deformation_.initialize(); }
    std::size_t workSize() const override { return deformation_.body().size(); }

 private:
    Deformation<Dim> deformation_;
};

/// Registers solid.linear_correction.
void declareLinearCorrection(input::Registry& registry);

}  // namespace sphinx::dynamics::solid
