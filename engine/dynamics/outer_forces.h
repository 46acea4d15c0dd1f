// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"

namespace sphinx::dynamics {

/// What acts on the particles of an elastic body besides its stresses.
template <int Dim>
struct OuterForces {
    explicit OuterForces(ParticleSet<Dim>& particles)
        : external(particles.vector(fields::external_acceleration)),
          pressure(particles.vector(fields::pressure_force)),
          viscous(particles.vector(fields::viscous_force)) {}

    /// Once all methods have asked for their fields.
    void prepare(ParticleSet<Dim>& particles) {
        if (particles.find(fields::contact_force.name))
            contact = &particles.vector(fields::contact_force);
    }

    Field<Vec<Dim>>& external;  ///< acceleration
    Field<Vec<Dim>>& pressure;  ///< of fluids
    Field<Vec<Dim>>& viscous;
    const Field<Vec<Dim>>* contact = nullptr;  ///< null where nobody has made it
};

}  // namespace sphinx::dynamics
