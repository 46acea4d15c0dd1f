// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/known_load.h"

#include <array>

namespace sphinx::dynamics::constraint {

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
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }

 private:
    Part<Dim> part_;
    std::array<bool, Dim> fixed_{};
    Field<Vec<Dim>>& velocity_;
    Field<double>& mass_;
};

/// Registers constraint.fix.
void declareFix(input::Registry& registry);

}  // namespace sphinx::dynamics::constraint
