// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/prescribed_motion.h"

#include "core/errors.h"
#include "core/sum_all.h"
#include "materials/elastic_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sphinx::constraint {

template <int Dim>
PrescribedMotion<Dim>::PrescribedMotion(const World<Dim>& world, Part<Dim> part,
                                        std::vector<input::FieldExpression> displacement,
                                        const std::vector<int>& directions)
    : world_(&world),
      part_(part),
      position_(part.body().particles.position()),
      velocity_(part.body().particles.vector(fields::velocity)),
      initial_position_(part.body().particles.vector(fields::initial_position)),
      displacement_(std::move(displacement)) {
    moves_.fill(directions.empty());
    for (const int axis : directions) moves_[static_cast<std::size_t>(axis)] = true;
}

template <int Dim>
void PrescribedMotion<Dim>::requireFinite(std::initializer_list<double> times) const {
    for (const double time : times) {
        const auto u = displacement(time);
        for (std::size_t n = 0; n < part_.size(); ++n) {
            const Vec<Dim>& start = initial_position_[part_[n]];
            for (int c = 0; c < Dim; ++c)
                if (moves(c) && !std::isfinite(u(start, c)))
                    throw PhysicsError(
                        fmt::format("the prescribed motion of {} displaces the particle that began "
                                    "at {} by {} along {} at time {}",
                                    part_.body().name, world_->placeText(start), u(start, c),
                                    "xyz"[c], world_ -> quantityText(time, unit::time)));
        }
    }
}

template <int Dim>
void PrescribedSolidMotion<Dim>::run(const Clock& clock) {
    if (clock.is_start) return;
    const double dt = clock.dt;
    auto& position = this->position_;
    auto& velocity = this->velocity_;
    const auto& mass = this->part_.body().particles.scalar(fields::mass);
    const auto before = this->displacement(clock.time);
    const auto after = this->displacement(clock.time + dt);
    const Vec<Dim> momentum = sumAll(this->part_.size(), [&](std::size_t n) {
        const std::size_t i = this->part_[n];
        const Vec<Dim>& start = this->initial_position_[i];
        Vec<Dim> gained = Vec<Dim>::Zero();
        for (int c = 0; c < Dim; ++c) {
            if (!this->moves(c)) continue;
            const double u = after(start, c);
            const double v = (u - before(start, c)) / dt;
            gained[c] = mass[i] * (v - velocity[i][c]);
            velocity[i][c] = v;
            position[i][c] = start[c] + u - 0.5 * dt * v;
        }
        return gained;
    });
    if (!momentum.allFinite()) this->requireFinite({clock.time, clock.time + dt});
    this->reaction_ = momentum / dt;
}

template <int Dim>
PrescribedWallMotion<Dim>::PrescribedWallMotion(const World<Dim>& world, Part<Dim> part,
                                                std::vector<input::FieldExpression> displacement,
                                                const std::vector<int>& directions)
    : PrescribedMotion<Dim>(world, part, std::move(displacement), directions),
      acceleration_(part.body().particles.vector(fields::acceleration)) {}

template <int Dim>
double PrescribedWallMotion<Dim>::wrapped(double x, int axis) const {
    const Domain<Dim>& domain = this->world_->domain;
    if (!domain.periodic[static_cast<std::size_t>(axis)]) return x;
    const double lower = domain.bounds.lower[axis];
    const double period = domain.bounds.upper[axis] - lower;
    return x - period * std::floor((x - lower) / period);
}

template <int Dim>
void PrescribedWallMotion<Dim>::run(const Clock& clock) {
    if (clock.is_start) return;
    const double dt = clock.dt;
    const double half = 0.5 * dt;
    auto& position = this->position_;
    auto& velocity = this->velocity_;
    const auto before = this->displacement(clock.time);
    const auto middle = this->displacement(clock.time + half);
    const auto after = this->displacement(clock.time + dt);
    const std::size_t spoilt = countLocal(this->part_.size(), [&](std::size_t n) {
        const std::size_t i = this->part_[n];
        const Vec<Dim>& start = this->initial_position_[i];
        double moved = 0;
        for (int c = 0; c < Dim; ++c) {
            if (!this->moves(c)) continue;
            const double u0 = before(start, c);
            const double u1 = middle(start, c);
            const double u2 = after(start, c);
            velocity[i][c] = (u2 - u0) / dt;
            acceleration_[i][c] = ((u2 - u1) - (u1 - u0)) / (half * half);
            position[i][c] = wrapped(start[c] + u2, c);
            moved += u0 + u1 + u2;
        }
        return !std::isfinite(moved);
    });
    if (spoilt > 0) this->requireFinite({clock.time, clock.time + half, clock.time + dt});
    ++this->part_.body().version;
}

template <int Dim>
void PrescribedWallMotion<Dim>::rest() {
    parallelFor(this->part_.size(), [&](std::size_t n) {
        const std::size_t i = this->part_[n];
        for (int c = 0; c < Dim; ++c) {
            if (!this->moves(c)) continue;
            this->velocity_[i][c] = 0;
            acceleration_[i][c] = 0;
        }
    });
}

namespace {

/// The particles start where the shape has them.
template <int Dim>
void checkStart(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<PrescribedMotionParameters>();
    const Part<Dim> part(built.world, p.part);
    const input::VectorAtTime<Dim> displacement(p.displacement, built.start_time);
    for (std::size_t n = 0; n < part.size(); ++n) {
        const Vec<Dim>& x = part.body().particles.position()[part[n]];
        Vec<Dim> u = displacement(x);
        for (int c = 0; c < Dim && !p.directions.empty(); ++c)
            if (std::ranges::find(p.directions, c) == p.directions.end()) u[c] = 0;
        if (u.norm() <= 1e-9 * part.body().spacing) continue;
        built.diagnostics.error(
            method.placeOf("displacement"),
            fmt::format("the displacement at {} is {} at the start, but must be zero there: the "
                        "particles start where the shape has them",
                        built.world.placeText(x), built.world.placeText(u)));
        return;
    }
}

}  // namespace

void declarePrescribedMotion(input::Registry& registry) {
    using P = PrescribedMotionParameters;
    auto& d = declareMethod<P>(
        registry, "constraint.prescribed_motion",
        []<int Dim>(const P& p, Context<Dim>& context) -> std::unique_ptr<PrescribedMotion<Dim>> {
            const Part<Dim> part(context.world, p.part);
            if (part.body().isElastic())
                return std::make_unique<PrescribedSolidMotion<Dim>>(context.world, part,
                                                                    p.displacement, p.directions);
            return std::make_unique<PrescribedWallMotion<Dim>>(context.world, part, p.displacement,
                                                               p.directions);
        });
    d.summary(
        "Moves particles of a solid as expressions of place and time say: of an elastic body "
        "between the halves of its step, of a rigid one (a wall that moves) at the start of "
        "the fluid's step");
    d.formula(
        "r = R + u(R, t + dt), v = (u(R, t + dt) - u(R, t))/dt; the fluid also sees the "
        "acceleration a = 4 (u(R, t + dt) - 2 u(R, t + dt/2) + u(R, t))/dt^2 of a rigid body");
    d.required("part", &P::part, input::partReference({"elastic", "rigid"}),
               "body, or part of a body; the normals of a rigid one stay as they are");
    d.required("displacement", &P::displacement, input::fieldVector(unit::length),
               "displacement u, one expression of t and of x, y, z, the initial position R, for "
               "each direction; zero at the start");
    d.optional("directions", &P::directions, input::axes(),
               "axes along which the motion is prescribed; without: all");
    d.worldRule([](const auto& method, auto& built) { checkStart(method, built); });
    d.action(
         "elastic: between the halves of the step; rigid: before the fluid's step, whose "
         "neighbors are stale from then on")
        .reads("part", {"initial_position", "position", "velocity", "acceleration", "mass"})
        .writes("part", {"position", "velocity", "acceleration"})
        .releases("part", {"velocity", "acceleration"})
        .within("part", "step");
}

template class PrescribedMotion<2>;
template class PrescribedMotion<3>;
template class PrescribedSolidMotion<2>;
template class PrescribedSolidMotion<3>;
template class PrescribedWallMotion<2>;
template class PrescribedWallMotion<3>;

}  // namespace sphinx::constraint
