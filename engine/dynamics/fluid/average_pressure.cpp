// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/average_pressure.h"

#include "core/parallel.h"

namespace sphinx::dynamics::fluid {

template <int Dim>
AveragePressure<Dim>::AveragePressure(Body<Dim>& body)
    : body_(&body),
      pressure_(body.particles.scalar(fields::pressure)),
      average_(body.particles.scalar(fields::average_pressure)) {}

template <int Dim>
void AveragePressure<Dim>::run(const Clock& clock) {
    if (clock.interval_start != interval_start_) {
        interval_start_ = clock.interval_start;
        elapsed_ = 0;
    }
    elapsed_ += clock.dt;
    const double share = clock.dt / elapsed_;  // 1 in the first substep: the last mean goes
    parallelFor(body_->size(), [&](std::size_t i) {
        average_[i] = (1 - share) * average_[i] + share * pressure_[i];
    });
}

void declareAveragePressure(input::Registry& registry) {
    using P = AveragePressureParameters;
    auto& d = declareMethod<P>(
        registry, "fluid.average_pressure", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<AveragePressure<Dim>>(bodyOf(context, p.body));
        });
    d.summary("Pressure of a fluid, averaged over the substeps of an interval of its layer");
    d.formula("average p = sum_k p_k dt_k / sum_k dt_k over the substeps k of an interval");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.action("after the first half of pressure relaxation")
        .reads("body", {"pressure"})
        .writes("body", {"average_pressure"});
}

template class AveragePressure<2>;
template class AveragePressure<3>;

}  // namespace sphinx::dynamics::fluid
