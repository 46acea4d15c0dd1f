// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

#include <limits>

namespace sphinx::dynamics::fluid {

struct AveragePressureParameters {
    input::Name body;
};

/// Mean of the pressure over the interval that its layer covers, weighted by the substeps. Where
/// summation (54) raises the density at the start of an advection step and the acoustic steps let
/// it sink again, the pressure at the end of the step is not the one that moved the fluid: the mean
/// is. At the start the mean is the pressure itself.
template <int Dim>
class AveragePressure final : public Method {
 public:
    explicit AveragePressure(Body<Dim>& body);

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    Field<double>& pressure_;
    Field<double>& average_;
    // Nothing of these outlives an outermost step: no state of a restart.
    double interval_start_ = std::numeric_limits<double>::quiet_NaN();
    double elapsed_ = 0;
};

/// Registers fluid.average_pressure.
void declareAveragePressure(input::Registry& registry);

}  // namespace sphinx::dynamics::fluid
