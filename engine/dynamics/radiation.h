// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/parallel.h"
#include "dynamics/words.h"

#include <Eigen/LU>

#include <array>

namespace sphinx::dynamics {

/// How fluids answer the motion of an elastic body at once. A body makes several steps in one of
/// its fluids, whose pressure p*_ij is that of the velocity u which they have seen
/// (average_velocity). A body that has changed its velocity since pushes sound into the fluid,
/// whose impedance answers with rho0 c0 (v - u) . e_ij more pressure: a force -Z (v - u) on the
/// particle, Z = 2 rho0 c0 sum_i abs(W') e_ij (x) e_ij V_i V_j over the fluid particles near it. It
/// is taken at the end of the kick, m dv = f dt - Z (v - u) dt, so that it holds for any step. The
/// fluid gets the impulse Z s of the slip s = sum (v - u) dt at the end of its own step: together
/// they lose no momentum. Without it the pressure would be a spring that acts a step late, which
/// feeds every vibration of more than a few radians a step, and whatever is lighter than the fluid
/// it moves.
///
/// Constraints that act between the halves move the inertia m + dt Z. To be made for one step of a
/// body: where no fluid pushes it nobody makes the fields, and all is as without them.
template <int Dim>
class Radiation {
 public:
    Radiation(ParticleSet<Dim>& particles, double dt)
        : dt_(dt),
          mass_(particles.scalar(fields::mass)),
          velocity_(particles.vector(fields::velocity)) {
        if (!particles.find(fields::radiation_impedance.name)) return;
        impedance_ = &particles.matrix(fields::radiation_impedance);
        seen_ = &particles.vector(fields::average_velocity);
        slip_ = &particles.vector(fields::slip);
    }

    /// Velocities and accelerations that have had the kick without the answer get it.
    void answer(Field<Vec<Dim>>& acceleration) {
        if (!impedance_) return;
        parallelFor(velocity_.size(), [&](std::size_t i) {
            if (!acts(i)) return;
            const Vec<Dim> a = moved(i, (*impedance_)[i] * ((*seen_)[i] - velocity_[i]));
            acceleration[i] += a;
            velocity_[i] += dt_ * a;
        });
    }
    /// Once constraints have acted.
    void addSlip() {
        if (!impedance_) return;
        parallelFor(velocity_.size(), [&](std::size_t i) {
            if (acts(i)) (*slip_)[i] += dt_ * (velocity_[i] - (*seen_)[i]);
        });
    }

    /// Acceleration by a force that comes on top.
    Vec<Dim> acceleration(std::size_t i, const Vec<Dim>& force) const {
        return acts(i) ? moved(i, force) : Vec<Dim>(force / mass_[i]);
    }
    /// Gives the velocity of a particle the values that are imposed on some of its components.
    /// Returns the force that does it, which has no others.
    Vec<Dim> impose(std::size_t i, const std::array<bool, Dim>& imposed, const Vec<Dim>& value);

 private:
    bool acts(std::size_t i) const { return impedance_ && (*impedance_)[i].trace() > 0; }
    Mat<Dim> inverseInertia(std::size_t i) const {
        const Mat<Dim> inertia = mass_[i] * Mat<Dim>::Identity() + dt_ * (*impedance_)[i];
        return inertia.inverse();
    }
    Vec<Dim> moved(std::size_t i, const Vec<Dim>& force) const { return inverseInertia(i) * force; }

    double dt_;
    Field<double>& mass_;
    Field<Vec<Dim>>& velocity_;
    const Field<Mat<Dim>>* impedance_ = nullptr;  // null: no fluids
    const Field<Vec<Dim>>* seen_ = nullptr;
    Field<Vec<Dim>>* slip_ = nullptr;
};

template <int Dim>
Vec<Dim> Radiation<Dim>::impose(std::size_t i, const std::array<bool, Dim>& imposed,
                                const Vec<Dim>& value) {
    Vec<Dim>& v = velocity_[i];
    Vec<Dim> change = Vec<Dim>::Zero();
    for (int c = 0; c < Dim; ++c)
        if (imposed[static_cast<std::size_t>(c)]) change[c] = value[c] - v[c];
    Vec<Dim> force = mass_[i] * change / dt_;
    if (acts(i)) {
        // Rows of a free component say that it gets no force.
        const Mat<Dim> inverse = inverseInertia(i);
        Mat<Dim> rows = Mat<Dim>::Identity();
        for (int c = 0; c < Dim; ++c)
            if (imposed[static_cast<std::size_t>(c)]) rows.row(c) = dt_ * inverse.row(c);
        force = rows.inverse() * change;
        v += dt_ * (inverse * force);
    }
    for (int c = 0; c < Dim; ++c)
        if (imposed[static_cast<std::size_t>(c)]) v[c] = value[c];
    return force;
}

}  // namespace sphinx::dynamics
