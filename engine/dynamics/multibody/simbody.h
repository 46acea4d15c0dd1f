// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Simbody's words for ours. Only for files that engine/CMakeLists.txt compiles as C++17:
// Simbody 3.7 is no C++20, whose rules find comparisons of numbers in its headers ambiguous.

#include "dynamics/multibody/mechanism.h"

#include <SimTKsimbody.h>

namespace sphinx::dynamics::multibody {

inline SimTK::Vec3 simtk(const Vector& a) { return {a[0], a[1], a[2]}; }
inline Vector eigen(const SimTK::Vec3& a) { return {a[0], a[1], a[2]}; }
inline Matrix eigen(const SimTK::Rotation& R) {
    Matrix m;
    m << R.x()[0], R.y()[0], R.z()[0], R.x()[1], R.y()[1], R.z()[1], R.x()[2], R.y()[2], R.z()[2];
    return m;
}
/// Velocity and angular velocity, or the same of force and moment: Simbody's pairs have the turning
/// part first.
inline Screw screw(const SimTK::SpatialVec& a) {
    Screw s;
    s << eigen(a[1]), eigen(a[0]);
    return s;
}
inline SimTK::SpatialVec spatial(const Screw& s) {
    return {simtk(Vector(s.tail<3>())), simtk(Vector(s.head<3>()))};
}

/// A point of a body in its frame, whose origin is the centre of mass.
struct Station {
    SimTK::MobilizedBody body;
    SimTK::Vec3 at;

    SimTK::Vec3 place(const SimTK::State& s) const {
        return body.findStationLocationInGround(s, at);
    }
    SimTK::Vec3 velocity(const SimTK::State& s) const {
        return body.findStationVelocityInGround(s, at);
    }
    void push(const SimTK::State& s, const SimTK::Vec3& force,
              SimTK::Vector_<SimTK::SpatialVec>& bodies) const {
        body.applyForceToBodyPoint(s, at, force, bodies);
    }
};

}  // namespace sphinx::dynamics::multibody
