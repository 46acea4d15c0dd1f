// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "particles/side_array.h"

#include <algorithm>

namespace sphinx::dynamics::fsi {
namespace {

/// Motion of an elastic body as its fluid sees it. Over one step of the fluid, in which the solid
/// makes several: the mean velocity u, its change since the step before as acceleration, and as
/// velocity u carried on to the end of the step, where the fluid uses it. (A fluid that sees the
/// velocity of half a step ago is a spring that pushes late: it feeds the plate's motion.) The
/// steps of the solid belong before the second half of the fluid's pressure relaxation.
///
/// Modes of a stiff plate that swing more than half a time in a step of the fluid radiate at
/// another frequency than their own, and swing up. Kelvin-Voigt damping holds them, or a smaller
/// `cfl` of the fluid's step (measured: cases/hydrostatic_plate_fsi_2d/README.md).
template <int Dim>
class AverageKinematics final : public Method {
 public:
    AverageKinematics(Context<Dim>& context, const BodyParameters& p)
        : body_(&bodyOf(context, p.body)),
          position_(body_->particles.position()),
          average_velocity_(body_->particles.vector(fields::average_velocity)),
          average_acceleration_(body_->particles.vector(fields::average_acceleration)),
          old_position_(body_->particles, [this](std::size_t i) { return position_[i]; }) {}
    void begin(const Clock&) { std::copy_n(position_.data(), body_->size(), old_position_.data()); }
    void end(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }
    void transfer(Archive& archive) override { archive.value("last_dt", last_dt_); }

 private:
    Body<Dim>* body_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& average_velocity_;
    Field<Vec<Dim>>& average_acceleration_;
    sphinx::particles::SideArray<Vec<Dim>>
        old_position_;  // at `begin`, or where a particle came since
    double last_dt_ = 0;
};

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

}  // namespace

void declareAverageKinematics(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareMethod<AverageKinematics, P>(registry, "fsi.average_kinematics");
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

}  // namespace sphinx::dynamics::fsi
