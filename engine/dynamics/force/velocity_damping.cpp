// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "core/parallel.h"
#include "dynamics/methods.h"

#include <fmt/format.h>
#include <cmath>

namespace sphinx::dynamics::force {
namespace {

/// Drag in proportion to mass and velocity, dv/dt = -rate v, by its solution over the substep of
/// its layer, v *= exp(-rate dt) with the rate in the middle of the step: stable at any rate and
/// step, and no particle gains energy. It brings a body to rest where the final state, not the way
/// to it, is asked for; a mode of the frequency omega is damped fastest at rate = 2 omega. In a
/// shape, with a rate that grows from zero, it is a beach: waves run into it and hardly come back.
struct VelocityDampingParameters {
    input::Name body;
    input::Name shape;  ///< empty: everywhere
    input::FieldExpression rate;
};

template <int Dim>
class VelocityDamping final : public Method {
 public:
    VelocityDamping(Context<Dim>& context, const VelocityDampingParameters& p)
        : world_(&context.world),
          body_(&bodyOf(context, p.body)),
          shape_(p.shape.empty() ? nullptr : context.world.shapes.at(p.shape.text)),
          rate_(p.rate),
          velocity_(body_->particles.vector(fields::velocity)) {}
    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    /// Names the first particle whose rate is none.
    [[noreturn]] void failAt(double time) const;

    const World<Dim>* world_;
    Body<Dim>* body_;
    sphinx::geometry::ShapePointer<Dim> shape_;
    input::FieldExpression rate_;
    Field<Vec<Dim>>& velocity_;
};

bool isRate(double rate) { return rate >= 0 && std::isfinite(rate); }

template <int Dim>
void VelocityDamping<Dim>::run(const Clock& clock) {
    const double middle = clock.time + 0.5 * clock.dt;
    const auto& position = body_->particles.position();
    const bool varies = rate_.dependsOnPlace();
    const double common = varies ? 0 : rate_(Vec<Dim>(Vec<Dim>::Zero()), middle);
    const double common_left = std::exp(-common * clock.dt);
    const Box<Dim> bounds = shape_ ? shape_->bounds() : Box<Dim>{};
    const std::size_t spoilt = countLocal(body_->size(), [&](std::size_t i) {
        const Vec<Dim>& x = position[i];
        if (shape_ && !(bounds.contains(x) && shape_->contains(x))) return false;
        const double rate = varies ? rate_(x, middle) : common;
        velocity_[i] *= varies ? std::exp(-rate * clock.dt) : common_left;
        return !isRate(rate);
    });
    if (spoilt > 0) failAt(middle);
}

template <int Dim>
void VelocityDamping<Dim>::failAt(double time) const {
    const auto& position = body_->particles.position();
    std::size_t i = 0;
    while (isRate(rate_(position[i], time)) || (shape_ && !shape_->contains(position[i]))) ++i;
    throw PhysicsError(fmt::format(
        "the rate of damping of {} is {} at {}, time {}, but must be a number of at least 0",
        body_->name, world_->quantityText(rate_(position[i], time), unit::frequency),
        world_->placeText(position[i]), world_->quantityText(time, unit::time)));
}

}  // namespace

void declareVelocityDamping(input::Registry& registry) {
    using P = VelocityDampingParameters;
    auto& d = declareMethod<VelocityDamping, P>(registry, "force.velocity_damping");
    d.summary(
        "Drag in proportion to mass and velocity, which brings a body to rest, or absorbs waves in "
        "a part of space");
    d.formula("dv_i/dt = -rate v_i, by v_i *= exp(-rate dt)");
    d.required("body", &P::body, input::bodyReference({"fluid", "elastic"}),
               "fluid or elastic body");
    d.optional("shape", &P::shape, input::shapeReference(),
               "where it acts: on the particles that are in it at the time; default: everywhere");
    d.required("rate", &P::rate, input::fieldExpression(unit::frequency),
               "part of the velocity that is lost per time, at least 0");
    d.check("rate", [](const P& p, const input::UnitSystem& units) -> std::string {
        return !p.rate.constant() || p.rate.value() > 0
                   ? ""
                   : fmt::format("rate is {}{} but must be above 0", p.rate.value(),
                                 units.suffix(unit::frequency));
    });
    d.action().reads("body", {"position", "velocity"}).writes("body", {"velocity"});
}

}  // namespace sphinx::dynamics::force
