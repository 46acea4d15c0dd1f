// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "dynamics/multibody/mechanism.h"
#include "dynamics/part.h"

namespace sphinx::dynamics::multibody {

/// Particles that a rigid body of a mechanism carries along: all of a rigid body of the case, or a
/// part of one or of an elastic body.
template <int Dim>
class MovedPart {
 public:
    MovedPart(World<Dim>& world, const input::Name& name);
    /// Once the particles are there.
    void prepare();

    /// At the start: rigid ones where the joints put them, elastic ones with the velocity.
    void place(const RigidBody& body, const BodyMotion& start);

    Body<Dim>& body() const { return part_.body(); }
    std::size_t size() const { return part_.size(); }
    /// Adds what acts on the particles, about the centre of mass: the force f of fluids, of elastic
    /// material and of methods that push it, and where fluids answer the motion within their step
    /// (Radiation) its Z and Z u. Of an elastic part the kick has been taken, v = v0 + a dt: f = m
    /// (a - g) + Z (v - u), without its force.gravity, because the mechanism has its own.
    void addLoad(const RigidBody& body, const BodyMotion& motion, BodyLoad& load);
    /// Moves the particles as the body has moved in a step that began at `before`. Rigid ones get
    /// place, velocity, acceleration and normal at its end. Elastic ones get
    /// the velocity at its end, as a kick would give it, and a place from which the drift of their
    /// second half leads to the end: so their deformation follows their places. (With the mean
    /// velocity it would be half a step late, and energy is lost.)
    void follow(const RigidBody& body, const BodyMotion& before, const BodyMotion& after,
                const Clock& clock);

 private:
    bool isLoaded(std::size_t i) const;
    void setRigid(std::size_t i, const RigidBody& body, const BodyMotion& motion);
    /// From the centre of mass, whichever periodic image of it the particle belongs to.
    Vector armOf(std::size_t i, const RigidBody& body, const BodyMotion& motion) const;
    /// The periodic image that is nearest to the particle.
    Vec<Dim> placeOf(std::size_t i, const RigidBody& body, const BodyMotion& motion) const;

    const Domain<Dim>* domain_;
    Part<Dim> part_;
    std::vector<std::size_t> loaded_;  // scratch
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& initial_position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& acceleration_;
    const Field<double>& mass_;
    // Where something has made them.
    const Field<Vec<Dim>>* pressure_force_ = nullptr;
    const Field<Vec<Dim>>* viscous_force_ = nullptr;
    const Field<Vec<Dim>>* contact_force_ = nullptr;
    const Field<Mat<Dim>>* contact_couple_ = nullptr;
    const Field<Mat<Dim>>* impedance_ = nullptr;
    const Field<Vec<Dim>>* seen_ = nullptr;
    Field<Vec<Dim>>* slip_ = nullptr;
    Field<Vec<Dim>>* normal_ = nullptr;
    const Field<Vec<Dim>>* initial_normal_ = nullptr;
};

}  // namespace sphinx::dynamics::multibody
