// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/parallel.h"
#include "dynamics/words.h"

#include <algorithm>

namespace sphinx::dynamics::fluid {

/// What pair terms read of a particle of a wall, in one load.
template <int Dim>
struct alignas(32) WallFace {
    static constexpr int stride = 4;

    double n[Dim];  ///< normal
    double V;       ///< volume
};

/// What a fluid sees of a solid. A solid that answers to forces (elastic, or of a mechanism) makes
/// several steps in one of the fluid: its velocity is averaged over them (fsi.average_kinematics).
/// Its acceleration is left out of the ghost pressure: what the fluid felt of it would push the
/// solid a step later, and a stiff plate under water (cases/hydrostatic_plate_fsi_2d) then swings
/// up at any step. That is an error of rho a r/2 in the pressure on it, of first order in the
/// spacing.
///
/// Pressure pushes along the line of the two particles. Only if the density of the fluid counts the
/// motion against the solid along the same line is the work on the solid taken from the fluid: so
/// it is with all that answers to forces. (Along normals a box that heels in still water drives
/// itself along, 0.4 m/s after ten seconds.) What closing in adds to the pressure goes along the
/// line for elastic solids, and along the normal for rigid ones, also those of a mechanism: along
/// the line it brakes a fluid that only slides past (a cylinder that enters water stays behind by a
/// tenth of its diameter, and by half of that at any spacing).
template <int Dim>
struct WallFields {
    bool responds;  ///< Body::responds
    /// Whether a motion against it counts along the line of the two particles, not its normal.
    struct AlongLine {
        bool density, pressure;
    } along_line;
    const Field<Vec<Dim>>* velocity;
    const Field<Vec<Dim>>* acceleration;  ///< null: not seen
    const Field<Vec<Dim>>* normal;
    const Field<double>* depth;
    const Field<double>* volume;
    const Field<Vec<Dim>>* slip;  ///< null: it makes no steps of its own
    /// Of its particles as they stand (look()), and whether velocity and acceleration are zero.
    AlignedVector<WallFace<Dim>> faces;
    bool stands_still = false;

    explicit WallFields(Body<Dim>& solid)
        : responds(solid.responds()), along_line{solid.responds(), solid.isElastic()} {
        ParticleSet<Dim>& p = solid.particles;
        velocity = &p.vector(responds ? fields::average_velocity : fields::velocity);
        acceleration = responds ? nullptr : &p.vector(fields::acceleration);
        normal = &p.vector(fields::normal);
        depth = &p.scalar(fields::depth);
        volume = &p.scalar(fields::volume);
        slip = responds ? &p.vector(fields::slip) : nullptr;
    }

    /// Once the solid may have moved.
    void look(const Body<Dim>& solid) {
        if (version_ == solid.version) return;
        version_ = solid.version;
        const auto zero = [&](const Field<Vec<Dim>>* field) {
            return !field || std::all_of(field->data(), field->data() + solid.held(),
                                         [](const Vec<Dim>& v) { return v.isZero(0); });
        };
        // What answers to forces has its velocity averaged at other times than it moves.
        stands_still = !responds && zero(velocity) && zero(acceleration);
        faces.resize(solid.held());
        parallelFor(faces.size(), [&](std::size_t j) {
            faces[j] = {};
            for (int c = 0; c < Dim; ++c) faces[j].n[c] = (*normal)[j][c];
            faces[j].V = (*volume)[j];
        });
    }

 private:
    std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace sphinx::dynamics::fluid
