// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/body.h"
#include "materials/elastic_solid.h"

namespace sphinx::fluid {

/// What a fluid sees of a solid. An elastic solid makes several steps in one of the fluid: its
/// motion is averaged over them (fsi.average_kinematics).
template <int Dim>
struct WallFields {
    const Field<Vec<Dim>>* velocity;
    const Field<Vec<Dim>>* acceleration;
    const Field<Vec<Dim>>* normal;
    const Field<double>* volume;

    explicit WallFields(Body<Dim>& solid) {
        const bool elastic = dynamic_cast<const ElasticSolid*>(solid.material.get());
        ParticleSet<Dim>& p = solid.particles;
        velocity = &p.vector(elastic ? fields::average_velocity : fields::velocity);
        acceleration = &p.vector(elastic ? fields::average_acceleration : fields::acceleration);
        normal = &p.vector(fields::normal);
        volume = &p.scalar(fields::volume);
    }
};

}  // namespace sphinx::fluid
