// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Velocities across no-slip walls, eight pairs of a fluid particle and a wall particle at a time.

#include "dynamics/fluid/terms/viscosity.h"
#include "dynamics/fluid/wall_fields.h"
#include "dynamics/pair_loop.h"

namespace sphinx::dynamics::fluid {

/// Of the spacing: least distance of a fluid particle from a wall that is told apart.
inline constexpr double nearest_to_wall = 0.25;

/// term(pair, continued, v_j, r, V_j) for the wall particles j near a fluid particle i: the
/// velocity difference, continued into the wall, is `continued` times v_i - v_j.
template <int Dim, class Term>
inline void forEachWallParticle(const WallFields<Dim>& wall, const NeighborList<Dim>& list,
                                std::size_t i, double nearest, Term&& term) {
    Distances<Dim> distances(list, i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        Lanes v_j[Dim];
        Lanes n[Dim];
        gatherVectors<Dim>(wall.velocity->data(), pair.index, v_j);
        gatherVectors<Dim>(wall.normal->data(), pair.index, n);
        const Lanes depth = gatherLanes(wall.depth->data(), pair.index);
        const Lanes continued = continuation<Dim, Lanes>(pair, r, n, depth, nearest);
        term(pair, continued, v_j, r, gatherLanes(wall.volume->data(), pair.index));
    });
}

/// term(pair, v_ij, r, V_j) of the same pairs for a fluid particle i of velocity v: with the
/// velocity difference continued into the wall.
template <int Dim, class Term>
inline void forEachWallPair(const WallFields<Dim>& wall, const NeighborList<Dim>& list,
                            std::size_t i, const Vec<Dim>& v, double nearest, Term&& term) {
    forEachWallParticle<Dim>(
        wall, list, i, nearest,
        [&](const Pairs<Dim>& pair, Lanes continued, const Lanes(&v_j)[Dim], Lanes r, Lanes V_j) {
            Lanes v_ij[Dim];
            for (int c = 0; c < Dim; ++c) v_ij[c] = continued * (v[c] - v_j[c]);
            term(pair, v_ij, r, V_j);
        });
}

/// The same for the fluid particles i near one wall particle j: term(pair, v_ji, r, V_i).
template <int Dim, class Term>
inline void forEachFluidPair(const WallFields<Dim>& wall, const NeighborList<Dim>& list,
                             std::size_t j, const Vec<Dim>* velocity, const Field<double>& volume,
                             double nearest, Term&& term) {
    Distances<Dim> distances(list, j);
    const Vec<Dim> vw = (*wall.velocity)[j];
    Lanes n[Dim];
    for (int c = 0; c < Dim; ++c) n[c] = lanes((*wall.normal)[j][c]);
    const Lanes depth = lanes((*wall.depth)[j]);
    forEachPair(list, j, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        const Lanes continued = continuation<Dim, Lanes>(pair, r, n, depth, nearest);
        Lanes v_ji[Dim];
        gatherVectors<Dim>(velocity, pair.index, v_ji);
        for (int c = 0; c < Dim; ++c) v_ji[c] = continued * (vw[c] - v_ji[c]);
        term(pair, v_ji, r, gatherLanes(volume.data(), pair.index));
    });
}

}  // namespace sphinx::dynamics::fluid
