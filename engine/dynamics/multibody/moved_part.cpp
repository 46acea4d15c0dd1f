// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/multibody/moved_part.h"

#include "core/parallel.h"
#include "core/sum_all.h"
#include "dynamics/multibody/in_space.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace sphinx::dynamics::multibody {
namespace {

/// A with A (v, omega) = v + omega x r.
Eigen::Matrix<double, 3, 6> motionAt(const Vector& r) {
    Eigen::Matrix<double, 3, 6> A;
    A << Matrix::Identity(),
        (Matrix() << 0, r[2], -r[1], -r[2], 0, r[0], r[1], -r[0], 0).finished();
    return A;
}

}  // namespace

template <int Dim>
MovedPart<Dim>::MovedPart(World<Dim>& world, const input::Name& name)
    : domain_(&world.domain),
      part_(world, name),
      position_(part_.body().particles.position()),
      initial_position_(part_.body().particles.vector(fields::initial_position)),
      velocity_(part_.body().particles.vector(fields::velocity)),
      acceleration_(part_.body().particles.vector(fields::acceleration)),
      mass_(part_.body().particles.scalar(fields::mass)) {}

template <int Dim>
void MovedPart<Dim>::prepare() {
    ParticleSet<Dim>& particles = part_.body().particles;
    const auto made = [&](const sphinx::particles::FieldInfo& field) {
        return particles.find(field.name) != nullptr;
    };
    if (made(fields::pressure_force)) pressure_force_ = &particles.vector(fields::pressure_force);
    if (made(fields::viscous_force)) viscous_force_ = &particles.vector(fields::viscous_force);
    if (made(fields::contact_force)) contact_force_ = &particles.vector(fields::contact_force);
    if (made(fields::contact_couple)) contact_couple_ = &particles.matrix(fields::contact_couple);
    if (made(fields::radiation_impedance)) {
        impedance_ = &particles.matrix(fields::radiation_impedance);
        seen_ = &particles.vector(fields::average_velocity);
        slip_ = &particles.vector(fields::slip);
    }
    if (!part_.body().isElastic() && made(fields::initial_normal)) {
        normal_ = &particles.vector(fields::normal);
        initial_normal_ = &particles.vector(fields::initial_normal);
    }
}

template <int Dim>
Vector MovedPart<Dim>::armOf(std::size_t i, const RigidBody& body, const BodyMotion& motion) const {
    return motion.rotation * (inSpace<Dim>(initial_position_[i]) - body.center);
}

template <int Dim>
Vec<Dim> MovedPart<Dim>::placeOf(std::size_t i, const RigidBody& body,
                                 const BodyMotion& motion) const {
    const Vec<Dim> place = (motion.center + armOf(i, body, motion)).template head<Dim>();
    // Whole periods, or exactly nothing.
    return place + (domain_->difference(place, position_[i]) - (place - position_[i]));
}

template <int Dim>
bool MovedPart<Dim>::isLoaded(std::size_t i) const {
    const Vec<Dim> none = Vec<Dim>::Zero();
    return (pressure_force_ && (*pressure_force_)[i] != none) ||
           (viscous_force_ && (*viscous_force_)[i] != none) ||
           (contact_force_ && (*contact_force_)[i] != none) ||
           (impedance_ && (*impedance_)[i].trace() > 0);
}

template <int Dim>
void MovedPart<Dim>::addLoad(const RigidBody& body, const BodyMotion& motion, BodyLoad& load) {
    const bool elastic = part_.body().isElastic();
    const Vec<Dim> gravity = part_.body().gravity();
    // Few particles of a large body are near a fluid.
    loaded_.clear();
    for (std::size_t n = 0; n < part_.size(); ++n)
        if (elastic || isLoaded(part_[n])) loaded_.push_back(part_[n]);
    // Four forces with their moments, Z u with its moment, and the upper triangle of the matrix.
    using Sum = std::array<double, 5 * 6 + 21>;
    const Sum sum = sumAll(loaded_.size(), [&](std::size_t n) {
        const std::size_t i = loaded_[n];
        const auto A = motionAt(armOf(i, body, motion));
        Matrix Z = Matrix::Zero();
        Vector u = Vector::Zero();
        if (impedance_ && (*impedance_)[i].trace() > 0) {
            Z.template topLeftCorner<Dim, Dim>() = (*impedance_)[i];
            u = inSpace<Dim>((*seen_)[i]);
        }
        Vec<Dim> pressure = Vec<Dim>::Zero(), viscous = pressure, material = pressure,
                 contact = pressure;
        if (pressure_force_) pressure = (*pressure_force_)[i];
        if (viscous_force_) viscous = (*viscous_force_)[i];
        if (contact_force_) contact = (*contact_force_)[i];
        if (elastic) {
            material = mass_[i] * (acceleration_[i] - gravity) - pressure - viscous - contact;
            material += (Z * (inSpace<Dim>(velocity_[i]) - u)).template head<Dim>();
        }
        const ScrewMatrix impedance = A.transpose() * Z * A;
        Sum terms;
        std::size_t k = 0;
        std::array<Screw, 5> forces;
        std::ranges::transform(
            std::array{inSpace<Dim>(pressure), inSpace<Dim>(viscous), inSpace<Dim>(material),
                       inSpace<Dim>(contact), Vector(Z * u)},
            forces.begin(), [&](const Vector& f) -> Screw { return A.transpose() * f; });
        if (contact_couple_) {
            Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
            C.template topLeftCorner<Dim, Dim>() = (*contact_couple_)[i];
            forces[3].template tail<3>() +=
                Vector(C(2, 1) - C(1, 2), C(0, 2) - C(2, 0), C(1, 0) - C(0, 1));
        }
        for (const Screw& force : forces)
            for (int c = 0; c < 6; ++c) terms[k++] = force[c];
        for (int row = 0; row < 6; ++row)
            for (int column = row; column < 6; ++column) terms[k++] = impedance(row, column);
        return terms;
    });
    std::size_t k = 0;
    for (Screw* force :
         {&load.pressure, &load.viscous, &load.material, &load.contact, &load.answered})
        for (int c = 0; c < 6; ++c) (*force)[c] += sum[k++];
    for (int row = 0; row < 6; ++row)
        for (int column = row; column < 6; ++column, ++k) {
            load.impedance(row, column) += sum[k];
            if (column != row) load.impedance(column, row) += sum[k];
        }
}

template <int Dim>
void MovedPart<Dim>::setRigid(std::size_t i, const RigidBody& body, const BodyMotion& motion) {
    position_[i] = placeOf(i, body, motion);
    const Vector r = armOf(i, body, motion);
    const auto A = motionAt(r);
    const Vector turning = motion.velocity.template tail<3>();
    velocity_[i] = Vector(A * motion.velocity).template head<Dim>();
    acceleration_[i] =
        Vector(A * motion.acceleration + turning.cross(turning.cross(r))).template head<Dim>();
    if (normal_)
        (*normal_)[i] =
            Vector(motion.rotation * inSpace<Dim>((*initial_normal_)[i])).template head<Dim>();
}

template <int Dim>
void MovedPart<Dim>::place(const RigidBody& body, const BodyMotion& start) {
    const bool elastic = part_.body().isElastic();
    parallelFor(part_.size(), [&](std::size_t n) {
        const std::size_t i = part_[n];
        if (!elastic) return setRigid(i, body, start);
        const auto A = motionAt(armOf(i, body, start));
        velocity_[i] = Vector(A * start.velocity).template head<Dim>();
    });
    ++part_.body().version;
}

template <int Dim>
void MovedPart<Dim>::follow(const RigidBody& body, const BodyMotion& before,
                            const BodyMotion& after, const Clock& clock) {
    const bool elastic = part_.body().isElastic();
    const double dt = clock.dt;
    parallelFor(part_.size(), [&](std::size_t n) {
        const std::size_t i = part_[n];
        if (elastic) {
            const Vec<Dim> end = placeOf(i, body, after);
            const auto A = motionAt(armOf(i, body, after));
            velocity_[i] = Vector(A * after.velocity).template head<Dim>();
            position_[i] = end - 0.5 * dt * velocity_[i];
            return;
        }
        if (slip_ && (*impedance_)[i].trace() > 0) {
            const auto A = motionAt(armOf(i, body, before));
            const Vec<Dim> s = Vec<Dim>((A * after.passed).template head<Dim>()) - dt * (*seen_)[i];
            // The part along the normal, as Z has it: both have turned when the fluid takes it.
            const Mat<Dim>& Z = (*impedance_)[i];
            (*slip_)[i] += Z * s / Z.trace();
        }
        setRigid(i, body, after);
    });
    ++part_.body().version;
}

template class MovedPart<2>;
template class MovedPart<3>;

}  // namespace sphinx::dynamics::multibody
