// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/average_kinematics.h"

#include "core/parallel.h"

#include <algorithm>

namespace sphinx::dynamics::fsi {

template <int Dim>
AverageKinematics<Dim>::AverageKinematics(Body<Dim>& body)
    : body_(&body),
      position_(body.particles.position()),
      average_velocity_(body.particles.vector(fields::average_velocity)),
      average_acceleration_(body.particles.vector(fields::average_acceleration)),
      old_position_(body.particles, [this](std::size_t i) { return position_[i]; }) {}

template <int Dim>
void AverageKinematics<Dim>::begin(const Clock&) {
    std::copy_n(position_.data(), body_->size(), old_position_.data());
}

template <int Dim>
void AverageKinematics<Dim>::end(const Clock& clock) {
    const double rate = 1 / clock.dt;
    parallelFor(body_->size(), [&](std::size_t i) {
        const Vec<Dim> v = rate * (position_[i] - old_position_[i]);
        // The field holds the last mean carried on to the end of its step.
        const Vec<Dim> last = average_velocity_[i] - 0.5 * last_dt_ * average_acceleration_[i];
        average_acceleration_[i] = rate * (v - last);
        average_velocity_[i] = v + 0.5 * (v - last);
    });
    last_dt_ = clock.dt;
}

template <int Dim>
void AverageKinematics<Dim>::transfer(Archive& archive) {
    archive.value("last_dt", last_dt_);
}

void declareAverageKinematics(input::Registry& registry) {
    using P = AverageKinematicsParameters;
    auto& d = declareMethod<P>(
        registry, "fsi.average_kinematics", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<AverageKinematics<Dim>>(bodyOf(context, p.body));
        });
    d.summary("Velocity and acceleration of an elastic body, averaged over a step of its fluid");
    d.formula(
        "guide 2.2.4: u = (r(t + dt) - r(t))/dt, average a = (u - u of the step before)/dt, "
        "average v = u + a dt/2");
    d.cite("guide", "2.2.4").cite("Zhang, Rezavand & Hu 2021");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.action("begin", "before the steps of the solid",
             [](auto& method, const Clock& clock) { method.begin(clock); })
        .reads("body", {"position"})
        .opens("body", "mean");
    d.action("end", "after them, in the same layer",
             [](auto& method, const Clock& clock) { method.end(clock); })
        .reads("body", {"position", "average_velocity", "average_acceleration"})
        .writes("body", {"average_velocity", "average_acceleration"})
        .closes("body", "mean");
}

template class AverageKinematics<2>;
template class AverageKinematics<3>;

}  // namespace sphinx::dynamics::fsi
