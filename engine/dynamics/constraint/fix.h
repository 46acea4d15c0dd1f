// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/constraint/support.h"
#include "dynamics/declare.h"
#include "dynamics/part.h"

#include <array>

namespace sphinx::constraint {

struct FixParameters {
    input::Name part;
    std::vector<int> directions;
};

/// Holds particles of an elastic body where they are: v = 0, in all or some directions. Between the
/// halves of the step, after the velocity has got its kick m dv = f dt, which is minus what the
/// support gives.
template <int Dim>
class Fix final : public Method, public Support<Dim> {
 public:
    Fix(Part<Dim> part, const std::vector<int>& directions);
    void run(const Clock& clock);
    std::size_t workSize() const override { return part_.size(); }
    void rest() override;

    const Body<Dim>& supported() const override { return part_.body(); }
    Vec<Dim> reaction() const override;
    void transfer(Archive& archive) override;

 private:
    Part<Dim> part_;
    std::array<bool, Dim> fixed_{};
    Field<Vec<Dim>>& velocity_;
    Field<double>& mass_;
    // What its particles have lost in the last step, and how long that was. Steps are many, and few
    // ask for the sum. 0: the reaction is known, or there has been no step.
    AlignedVector<Vec<Dim>> momentum_;
    double duration_ = 0;
};

/// Registers constraint.fix.
void declareFix(input::Registry& registry);

}  // namespace sphinx::constraint
