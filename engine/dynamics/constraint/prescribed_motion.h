// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/constraint/motion.h"
#include "dynamics/declare.h"
#include "dynamics/known_load.h"

#include <array>
#include <initializer_list>

namespace sphinx::dynamics::constraint {

struct PrescribedMotionParameters {
    input::Name part;
    std::vector<input::FieldExpression> displacement;  ///< empty: rotation or translation
    std::optional<RotationParameters> rotation;
    std::vector<input::FieldExpression> translation;
    std::vector<int> directions;

    /// What is wrong with them together, or empty.
    std::string violation() const;
    template <int Dim>
    Motion<Dim> motion() const {
        if (!displacement.empty()) return Motion<Dim>(displacement);
        return Motion<Dim>(rotation, translation);
    }
};

/// Motion r = R + u(R, t) of particles with the initial position R, in all or some directions, by
/// the displacements at the times of a step alone: it holds no state of its own.
template <int Dim>
class PrescribedMotion : public Method {
 public:
    PrescribedMotion(const World<Dim>& world, Part<Dim> part, Motion<Dim> motion,
                     const std::vector<int>& directions);
    virtual void run(const Clock& clock) = 0;
    std::size_t workSize() const override { return part_.size(); }

 protected:
    bool moves(int axis) const { return moves_[static_cast<std::size_t>(axis)]; }
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
    PrescribedSolidMotion(const World<Dim>& world, Part<Dim> part, Motion<Dim> motion,
                          const std::vector<int>& directions)
        : PrescribedMotion<Dim>(world, part, std::move(motion), directions), Support<Dim>(part) {}
    void run(const Clock& clock) override;
    void rest() override { this->setLoad({}); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }
};

/// Of a rigid body, at the start of a step: the position R + u(t + dt) at its end, and velocity and
/// acceleration at its middle by central differences,
/// v = (u(t + dt) - u(t))/dt, a = (u(t + dt) - 2 u(t + dt/2) + u(t))/(dt/2)^2. Normals turn with
/// the body, n = F^-T N / abs(F^-T N) (Nanson's formula) at the end of the step. When the window of
/// its line is over, the wall stands still where it is.
template <int Dim>
class PrescribedWallMotion final : public PrescribedMotion<Dim> {
 public:
    PrescribedWallMotion(const World<Dim>& world, Part<Dim> part, Motion<Dim> motion,
                         const std::vector<int>& directions);
    void prepare() override;
    void run(const Clock& clock) override;
    void rest() override;

 private:
    /// Into the period of the domain.
    double wrapped(double x, int axis) const;
    void turnNormals(const MotionAt<Dim>& after);

    Field<Vec<Dim>>& acceleration_;
    // Where something has found them.
    Field<Vec<Dim>>* normal_ = nullptr;
    const Field<Vec<Dim>>* initial_normal_ = nullptr;
};

/// Registers constraint.prescribed_motion.
void declarePrescribedMotion(input::Registry& registry);

}  // namespace sphinx::dynamics::constraint
