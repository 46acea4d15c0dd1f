// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"

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
/// feeds vibrations of more than a few tenths of a radian a step, and what is lighter than the
/// fluid it moves.
///
/// Constraints that act between the halves move the inertia m + dt Z.
template <int Dim>
class Radiation {
 public:
    explicit Radiation(ParticleSet<Dim>& particles)
        : particles_(&particles),
          mass_(particles.scalar(fields::mass)),
          velocity_(particles.vector(fields::velocity)) {}

    /// What follows is about a step of the body by dt. Where no fluid pushes it nobody has made the
    /// fields, and all is as without them.
    void begin(double dt) {
        dt_ = dt;
        if (looked_) return;
        looked_ = true;
        if (!particles_->find(fields::radiation_impedance.name)) return;
        impedance_ = &particles_->matrix(fields::radiation_impedance);
        seen_ = &particles_->vector(fields::average_velocity);
        slip_ = &particles_->vector(fields::slip);
    }

    bool acts() const { return impedance_ != nullptr; }
    /// Where it acts: what the answer adds to the acceleration of particles whose velocity is v
    /// after the kick without it.
    VecOf<Dim, Wide> answer(const Group& group, const VecOf<Dim, Wide>& v) const {
        if (isZero(*impedance_, group)) return VecOf<Dim, Wide>::Zero();
        const MatOf<Dim, Wide> Z = load(*impedance_, group);
        const MatOf<Dim, Wide> inertia =
            load(mass_, group) * MatOf<Dim, Wide>::Identity() + dt_ * Z;
        return inertia.inverse() * (Z * (load(*seen_, group) - v));
    }
    /// Once constraints have acted.
    void addSlip() {
        if (!acts()) return;
        parallelForGroups(velocity_.size(), [&](const Group& group) {
            if (isZero(*impedance_, group)) return;
            const Wide answered = load(*impedance_, group).trace();
            const VecOf<Dim, Wide> passed = dt_ * (load(velocity_, group) - load(*seen_, group));
            VecOf<Dim, Wide> slip = load(*slip_, group);
            for (int c = 0; c < Dim; ++c) slip[c] += select(answered > 0, passed[c], 0);
            store(slip, *slip_, group);
        });
    }

    /// Acceleration by a force that comes on top.
    Vec<Dim> acceleration(std::size_t i, const Vec<Dim>& force) const {
        return acts(i) ? Vec<Dim>(inertia(i).inverse() * force) : Vec<Dim>(force / mass_[i]);
    }
    /// Gives the velocity of a particle the values that are imposed on some of its components.
    /// Returns the force that does it, which has no others.
    Vec<Dim> impose(std::size_t i, const std::array<bool, Dim>& imposed, const Vec<Dim>& value) {
        Vec<Dim>& v = velocity_[i];
        Vec<Dim> change = Vec<Dim>::Zero();
        bool all = true;
        for (int c = 0; c < Dim; ++c) {
            if (imposed[static_cast<std::size_t>(c)]) {
                change[c] = value[c] - v[c];
                v[c] = value[c];
            } else {
                all = false;
            }
        }
        const Vec<Dim> force = mass_[i] / dt_ * change;
        if (!acts(i)) return force;
        return all ? Vec<Dim>(force + (*impedance_)[i] * change) : pushed(i, imposed, change);
    }
    /// The same for eight of them, of which all components become 0.
    VecOf<Dim, Wide> stop(const Group& group) {
        const VecOf<Dim, Wide> change = -load(velocity_, group);
        VecOf<Dim, Wide> force = load(mass_, group) / dt_ * change;
        if (acts() && !isZero(*impedance_, group)) force += load(*impedance_, group) * change;
        setZero(velocity_, group);
        return force;
    }

 private:
    /// Where it acts and some components are free: changes these by what comes with the change of
    /// the imposed ones. Returns the force.
    Vec<Dim> pushed(std::size_t i, const std::array<bool, Dim>& imposed, const Vec<Dim>& change);
    bool acts(std::size_t i) const { return acts() && (*impedance_)[i].trace() > 0; }
    Mat<Dim> inertia(std::size_t i) const {
        return mass_[i] * Mat<Dim>::Identity() + dt_ * (*impedance_)[i];
    }

    ParticleSet<Dim>* particles_;
    Field<double>& mass_;
    Field<Vec<Dim>>& velocity_;
    double dt_ = 0;
    bool looked_ = false;
    const Field<Mat<Dim>>* impedance_ = nullptr;  // null: no fluids
    const Field<Vec<Dim>>* seen_ = nullptr;
    Field<Vec<Dim>>* slip_ = nullptr;
};

template <int Dim>
Vec<Dim> Radiation<Dim>::pushed(std::size_t i, const std::array<bool, Dim>& imposed,
                                const Vec<Dim>& change) {
    Vec<Dim>& v = velocity_[i];
    // Rows of a free component say that it gets no force.
    const Mat<Dim> inverse = inertia(i).inverse();
    Mat<Dim> rows = Mat<Dim>::Identity();
    for (int c = 0; c < Dim; ++c)
        if (imposed[static_cast<std::size_t>(c)]) rows.row(c) = dt_ * inverse.row(c);
    const Vec<Dim> force = rows.inverse() * change;
    const Vec<Dim> moved = dt_ * (inverse * force);
    for (int c = 0; c < Dim; ++c)
        if (!imposed[static_cast<std::size_t>(c)]) v[c] += moved[c];
    return force;
}

}  // namespace sphinx::dynamics
