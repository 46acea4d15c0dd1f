// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"

#include <limits>

namespace sphinx::dynamics::fluid {

/// Mean of the pressure over the interval that its layer covers, weighted by the substeps. Where
/// summation (54) raises the density at the start of an advection step and the acoustic steps let
/// it sink again, the pressure at the end of the step is not the one that moved the fluid: the mean
/// is. At the start the mean is the pressure itself.
void declareAveragePressure(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareBodyMethod<P>(
        registry, "fluid.average_pressure", []<int Dim>(const P&, Body<Dim>& body, Context<Dim>&) {
            const auto& pressure = body.particles.scalar(fields::pressure);
            auto& average = body.particles.scalar(fields::average_pressure);
            // Nothing of the interval outlives an outermost step: no state of a restart.
            return [&, interval_start = std::numeric_limits<double>::quiet_NaN(),
                    elapsed = 0.0](const Clock& clock) mutable {
                if (clock.interval_start != interval_start) {
                    interval_start = clock.interval_start;
                    elapsed = 0;
                }
                elapsed += clock.dt;
                // 1 in the first substep: the last mean goes.
                const double share = clock.dt / elapsed;
                parallelFor(body.size(), [&](std::size_t i) {
                    average[i] = (1 - share) * average[i] + share * pressure[i];
                });
            };
        });
    d.summary("Pressure of a fluid, averaged over the substeps of an interval of its layer");
    d.formula("average p = sum_k p_k dt_k / sum_k dt_k over the substeps k of an interval");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.action("after the first half of pressure relaxation")
        .reads("body", {"pressure"})
        .writes("body", {"average_pressure"});
}

}  // namespace sphinx::dynamics::fluid
