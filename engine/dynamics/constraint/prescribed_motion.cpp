// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/constraint/prescribed_motion.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "dynamics/known_load.h"
#include "dynamics/methods.h"
#include "dynamics/radiation.h"
#include "dynamics/turned_normal.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace sphinx::dynamics::constraint {
namespace {

/// What both motions have.
template <int Dim>
class PrescribedMotion : public Method {
 public:
    PrescribedMotion(Context<Dim>& context, const PrescribedMotionParameters& p);
    virtual void run(const Clock& clock) = 0;
    std::size_t workSize() const override { return part_.size(); }

 protected:
    bool moves(int axis) const { return moves_[static_cast<std::size_t>(axis)]; }
    const std::array<bool, Dim>& moves() const { return moves_; }
    /// Throws PhysicsError where u is not finite at one of these times.
    void requireFinite(std::initializer_list<double> times) const;

    const World<Dim>* world_;
    Part<Dim> part_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& initial_position_;
    Motion<Dim> motion_;

 private:
    std::array<bool, Dim> moves_{};
};

/// Of an elastic body, between the halves of its step: v = (u(t + dt) - u(t))/dt, and a position
/// from which the drift of the second half leads to R + u(t + dt). The reaction is what takes the
/// velocity from its value after the kick m dv = f dt to that one.
template <int Dim>
class PrescribedSolidMotion final : public PrescribedMotion<Dim>, public Support<Dim> {
 public:
    PrescribedSolidMotion(Context<Dim>& context, const PrescribedMotionParameters& p)
        : PrescribedMotion<Dim>(context, p),
          Support<Dim>(this->part_),
          radiation_(this->part_.body().particles) {}
    void run(const Clock& clock) override;
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }

 private:
    Radiation<Dim> radiation_;
};

/// Of a rigid body, at the start of a step: the position R + u(t + dt) at its end, and velocity and
/// acceleration at its middle by central differences,
/// v = (u(t + dt) - u(t))/dt, a = (u(t + dt) - 2 u(t + dt/2) + u(t))/(dt/2)^2. Normals turn with
/// the body, n = F^-T N / abs(F^-T N) (Nanson's formula) at the end of the step. When the window of
/// its line is over, the wall stands still where it is.
template <int Dim>
class PrescribedWallMotion final : public PrescribedMotion<Dim> {
 public:
    PrescribedWallMotion(Context<Dim>& context, const PrescribedMotionParameters& p)
        : PrescribedMotion<Dim>(context, p),
          acceleration_(this->part_.body().particles.vector(fields::acceleration)) {}
    void prepare() override;
    void run(const Clock& clock) override;
    void rest() override;

 private:
    void turnNormals(const MotionAt<Dim>& after);

    Field<Vec<Dim>>& acceleration_;
    // Where something has found them.
    Field<Vec<Dim>>* normal_ = nullptr;
    const Field<Vec<Dim>>* initial_normal_ = nullptr;
};

template <int Dim>
PrescribedMotion<Dim>::PrescribedMotion(Context<Dim>& context, const PrescribedMotionParameters& p)
    : world_(&context.world),
      part_(context.world, p.part),
      position_(part_.body().particles.position()),
      velocity_(part_.body().particles.vector(fields::velocity)),
      initial_position_(part_.body().particles.vector(fields::initial_position)),
      motion_(p.template motion<Dim>()) {
    moves_.fill(p.directions.empty());
    for (const int axis : p.directions) moves_[static_cast<std::size_t>(axis)] = true;
}

template <int Dim>
void PrescribedMotion<Dim>::requireFinite(std::initializer_list<double> times) const {
    for (const double time : times) {
        const auto u = motion_.at(time);
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
    radiation_.begin(dt);
    const auto before = this->motion_.at(clock.time);
    const auto after = this->motion_.at(clock.time + dt);
    AlignedVector<Vec<Dim>>& force = this->forces();
    const std::size_t spoilt = countLocal(this->part_.size(), [&](std::size_t n) {
        const std::size_t i = this->part_[n];
        const Vec<Dim>& start = this->initial_position_[i];
        Vec<Dim> v = Vec<Dim>::Zero();
        for (int c = 0; c < Dim; ++c) {
            if (!this->moves(c)) continue;
            const double u = after(start, c);
            v[c] = (u - before(start, c)) / dt;
            position[i][c] = start[c] + u - 0.5 * dt * v[c];
        }
        force[n] = radiation_.impose(i, this->moves(), v);
        return !force[n].allFinite();
    });
    if (spoilt > 0) this->requireFinite({clock.time, clock.time + dt});
}

template <int Dim>
void PrescribedWallMotion<Dim>::prepare() {
    ParticleSet<Dim>& particles = this->part_.body().particles;
    if (!this->motion_.turns() || !particles.find(fields::initial_normal.name)) return;
    normal_ = &particles.vector(fields::normal);
    initial_normal_ = &particles.vector(fields::initial_normal);
}

template <int Dim>
void PrescribedWallMotion<Dim>::run(const Clock& clock) {
    if (clock.is_start) return;
    const double dt = clock.dt;
    const double half = 0.5 * dt;
    auto& position = this->position_;
    auto& velocity = this->velocity_;
    const auto before = this->motion_.at(clock.time);
    const auto middle = this->motion_.at(clock.time + half);
    const auto after = this->motion_.at(clock.time + dt);
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
            position[i][c] = this->world_->domain.wrapped(start[c] + u2, c);
            moved += u0 + u1 + u2;
        }
        return !std::isfinite(moved);
    });
    if (spoilt > 0) this->requireFinite({clock.time, clock.time + half, clock.time + dt});
    if (normal_) turnNormals(after);
    ++this->part_.body().version;
}

template <int Dim>
void PrescribedWallMotion<Dim>::turnNormals(const MotionAt<Dim>& after) {
    const double step = 1e-3 * this->part_.body().spacing;
    parallelFor(this->part_.size(), [&](std::size_t n) {
        const std::size_t i = this->part_[n];
        Mat<Dim> F = after.gradient(this->initial_position_[i], step);
        for (int c = 0; c < Dim; ++c)
            if (!this->moves(c)) F.row(c) = Vec<Dim>::Unit(c).transpose();
        (*normal_)[i] = turnedNormal<Dim>(F, (*initial_normal_)[i], (*normal_)[i]);
    });
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

/// A turn has an axis, in 3D.
template <int Dim>
bool checkAxis(const input::Component& method, const RotationParameters& rotation,
               input::Diagnostics& diagnostics) {
    const bool directed = rotation.axis && rotation.axis->template as<Dim>().norm() > 0;
    if (Dim == 3 ? directed : !rotation.axis) return true;
    diagnostics.error(method.placeOf("rotation"),
                      Dim == 2        ? "a rotation in 2D is about z: 'axis' is for 3D"
                      : rotation.axis ? "the axis of the rotation has no direction"
                                      : "a rotation in 3D needs an 'axis'");
    return false;
}

/// The particles start where the shape has them.
template <int Dim>
void checkStart(const input::Component& method, BuiltCase<Dim>& built) {
    const auto& p = method.as<PrescribedMotionParameters>();
    if (p.rotation && !checkAxis<Dim>(method, *p.rotation, built.diagnostics)) return;
    const ConstPart<Dim> part(built.world, p.part);
    const Motion<Dim> motion = p.motion<Dim>();
    const auto displacement = motion.at(built.start_time);
    for (std::size_t n = 0; n < part.size(); ++n) {
        const Vec<Dim>& x = part.body().particles.position()[part[n]];
        Vec<Dim> u;
        for (int c = 0; c < Dim; ++c) {
            const bool moves =
                p.directions.empty() || std::ranges::find(p.directions, c) != p.directions.end();
            u[c] = moves ? displacement(x, c) : 0;
        }
        if (u.norm() <= 1e-9 * part.body().spacing) continue;
        const char* parameter = !p.displacement.empty() ? "displacement"
                                : p.rotation            ? "rotation"
                                                        : "translation";
        built.diagnostics.error(
            method.placeOf(parameter),
            fmt::format("the displacement at {} is {} at the start, but must be zero there: the "
                        "particles start where the shape has them",
                        built.world.placeText(x), built.world.placeText(u)));
        return;
    }
}

/// Of a rigid body that a fluid sees: where it goes out of the domain it takes the fluid along.
/// Looked at in some of its particles, at some times.
template <int Dim>
void checkStaysInside(const input::Component& method, BuiltCase<Dim>& built) {
    constexpr int times = 100;
    constexpr std::size_t most_particles = 1000;
    const auto& p = method.as<PrescribedMotionParameters>();
    const ConstPart<Dim> part(built.world, p.part);
    const Body<Dim>& body = part.body();
    const bool seen = std::ranges::any_of(built.world.bodies, [&](const auto& other) {
        return other->isFluid() && built.sees(other->name, body.name);
    });
    if (!body.isWall() || !seen || !built.calls(method)) return;
    Box<Dim> bounds = built.world.domain.bounds;
    for (int k = 0; k < Dim; ++k)
        if (built.world.domain.periodic[k]) {
            bounds.lower[k] = -std::numeric_limits<double>::max();
            bounds.upper[k] = std::numeric_limits<double>::max();
        }
    const Motion<Dim> motion = p.motion<Dim>();
    const auto& position = body.particles.position();
    const std::size_t stride = part.size() / most_particles + 1;
    for (int k = 1; k <= times; ++k) {
        const double time = built.start_time + (built.end_time - built.start_time) * k / times;
        const auto displacement = motion.at(time);
        for (std::size_t n = 0; n < part.size(); n += stride) {
            const Vec<Dim>& start = position[part[n]];
            Vec<Dim> place = start;
            for (int c = 0; c < Dim; ++c)
                if (p.directions.empty() ||
                    std::ranges::find(p.directions, c) != p.directions.end())
                    place[c] += displacement(start, c);
            if (!bounds.contains(start) || bounds.contains(place) || !place.allFinite()) continue;
            built.diagnostics.warning(
                method.place,
                fmt::format("{} carries {} out of the domain, which reaches from {} to {}: a "
                            "particle that begins at {} is at {} at time {}; fluid that goes with "
                            "it is lost. Enlarge 'domain'",
                            method.name, body.name,
                            built.world.placeText(built.world.domain.bounds.lower),
                            built.world.placeText(built.world.domain.bounds.upper),
                            built.world.placeText(start), built.world.placeText(place),
                            built.world.quantityText(time, unit::time)));
            return;
        }
    }
}

bool dependsOnPlace(const std::vector<input::FieldExpression>& expressions) {
    return std::ranges::any_of(expressions, [](const auto& e) { return e.dependsOnPlace(); });
}

const input::Declaration& declareRotation(input::Registry& registry) {
    using P = RotationParameters;
    auto& d = registry.declare<P>(input::Kind::block, "constraint.prescribed_motion.rotation");
    d.summary("Turn about a point, in 3D about an axis through it");
    d.required("about", &P::about, input::coordinates(unit::length), "point that stays");
    d.required("angle", &P::angle, input::fieldExpression(unit::none),
               "angle in radians, an expression of t; counter-clockwise, in 3D as the axis points "
               "to the eye");
    d.optional("axis", &P::axis, input::coordinates(unit::none), "3D: direction of the axis");
    return d;
}

}  // namespace

std::string PrescribedMotionParameters::violation() const {
    const bool whole = rotation || !translation.empty();
    if (displacement.empty() && !whole)
        return "there is no motion: give 'displacement', or 'rotation', 'translation' or both";
    if (!displacement.empty() && whole)
        return "'displacement' says the whole motion: 'rotation' and 'translation' are instead of "
               "it";
    if (whole && !directions.empty()) return "'directions' are for 'displacement'";
    if (dependsOnPlace(translation) || (rotation && rotation->angle.dependsOnPlace()))
        return "a body that moves as a whole has expressions of t alone: x, y and z are for "
               "'displacement'";
    return "";
}

void declarePrescribedMotion(input::Registry& registry) {
    using P = PrescribedMotionParameters;
    auto& d = declareMethod<P>(
        registry, "constraint.prescribed_motion",
        []<int Dim>(const P& p, Context<Dim>& context) -> std::unique_ptr<PrescribedMotion<Dim>> {
            if (Part<Dim>(context.world, p.part).body().isElastic())
                return std::make_unique<PrescribedSolidMotion<Dim>>(context, p);
            return std::make_unique<PrescribedWallMotion<Dim>>(context, p);
        });
    d.summary(
        "Moves particles of a solid as expressions of place and time say: of an elastic body "
        "between the halves of its step, of a rigid one (a wall that moves) at the start of "
        "the fluid's step");
    d.formula(
        "r = R + u(R, t + dt), v = (u(R, t + dt) - u(R, t))/dt; the fluid also sees the "
        "acceleration a = 4 (u(R, t + dt) - 2 u(R, t + dt/2) + u(R, t))/dt^2 of a rigid body");
    d.required("part", &P::part, input::partReference({"elastic", "rigid"}),
               "body, or part of a body; the normals of a rigid one turn with it");
    d.optional("displacement", &P::displacement, input::fieldVector(unit::length),
               "displacement u, one expression of t and of x, y, z, the initial position R, for "
               "each direction; zero at the start");
    d.optional("rotation", &P::rotation,
               input::structure<RotationParameters>(declareRotation(registry)),
               "turn of the part as a whole, zero at the start");
    d.optional("translation", &P::translation, input::fieldVector(unit::length),
               "shift of the part as a whole, besides its rotation or alone: one expression of t "
               "for each direction, zero at the start");
    d.optional("directions", &P::directions, input::axes(),
               "axes along which the motion is prescribed; without: all");
    d.check("", [](const P& p) { return p.violation(); });
    d.worldRule([](const auto& method, auto& built) {
        checkStart(method, built);
        if (!built.diagnostics.hasErrors()) checkStaysInside(method, built);
    });
    d.action(
         "elastic: between the halves of the step; rigid: before the fluid's step, whose "
         "neighbors are stale from then on")
        .reads("part", {"initial_position", "position", "velocity", "acceleration", "mass"})
        .writes("part", {"position", "velocity", "acceleration"})
        .mayRead("part.elastic", {"radiation_impedance"})
        .mayRead("part.rigid", {"initial_normal", "normal"})
        .mayWrite("part.rigid", {"normal"})
        .releases("part", {"velocity", "acceleration"})
        .releases("part.rigid", {"normal"})
        .within("part", "step");
}

}  // namespace sphinx::dynamics::constraint
