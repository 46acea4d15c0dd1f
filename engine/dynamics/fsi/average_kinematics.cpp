// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "particles/side_array.h"

#include <algorithm>

namespace sphinx::dynamics::fsi {
namespace {

/// Motion of an elastic body as its fluid sees it: over one step of the fluid, in which the solid
/// makes several, the mean velocity. The steps of the solid belong before the second half of the
/// fluid's pressure relaxation. What the solid does in between is answered by the fluid's impedance
/// (Radiation); with that answer the mean velocity is stable, and a velocity that is carried on to
/// the end of the step is not: README.md.
template <int Dim>
class AverageKinematics final : public Method {
 public:
    AverageKinematics(Context<Dim>& context, const BodyParameters& p)
        : body_(&bodyOf(context, p.body)),
          position_(body_->particles.position()),
          average_velocity_(body_->particles.vector(fields::average_velocity)),
          slip_(body_->particles.vector(fields::slip)),
          old_position_(body_->particles, [this](std::size_t i) { return position_[i]; }) {}
    void begin(const Clock&) {
        std::copy_n(position_.data(), body_->size(), old_position_.data());
        slip_.setZero();
    }
    void end(const Clock& clock) {
        const double rate = 1 / clock.dt;
        parallelFor(body_->size(), [&](std::size_t i) {
            average_velocity_[i] = rate * (position_[i] - old_position_[i]);
        });
    }
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& average_velocity_;
    Field<Vec<Dim>>& slip_;
    sphinx::particles::SideArray<Vec<Dim>>
        old_position_;  // at `begin`, or where a particle came since
};

}  // namespace

void declareAverageKinematics(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareMethod<AverageKinematics, P>(registry, "fsi.average_kinematics");
    d.summary("Velocity of an elastic body, averaged over a step of its fluid");
    d.formula("guide 2.2.4: average v = (r(t + dt) - r(t))/dt");
    d.cite("guide", "2.2.4").cite("Zhang, Rezavand & Hu 2021");
    d.required("body", &P::body, input::bodyReference({"elastic", "rigid"}),
               "elastic body, or rigid body that a mechanism moves");
    d.action("begin", "before the steps of the solid",
             [](auto& method, const Clock& clock) { method.begin(clock); })
        .reads("body", {"position"})
        .writes("body", {"slip"})
        .opens("body", "mean");
    d.action("end", "after them, in the same layer",
             [](auto& method, const Clock& clock) { method.end(clock); })
        .reads("body", {"position"})
        .writes("body", {"average_velocity"})
        .closes("body", "mean");
}

}  // namespace sphinx::dynamics::fsi
