// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums over the particles of another liquid near one of a fluid, eight pairs at a time. Each liquid
// sums its own side: of the same numbers, so what one gets the other loses.

#include "core/aligned.h"
#include "core/exact_sum.h"
#include "core/parallel.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/terms/interface.h"
#include "dynamics/pair_loop.h"

namespace sphinx::dynamics::fluid {

/// Where the other liquid lies, seen from each particle: sum_j e_ij W', of any length.
template <int Dim>
inline void findFacing(const NeighborList<Dim>& list, AlignedVector<Vec<Dim>>& facing) {
    facing.resize(list.ranges.size());
    // Gradients are whole numbers below 2^31, of some hundred neighbors.
    const SumGrid grid(0x1p40);
    parallelFor(facing.size(), [&](std::size_t i) {
        ExactSums<Dim> sum(grid);
        forEachPair(list, i, [&](const Pairs<Dim>& pair) {
            for (int c = 0; c < Dim; ++c) sum[c].add(pair.gradient[c]);
        });
        for (int c = 0; c < Dim; ++c) facing[i][c] = sum[c].value();
    });
}

/// Adds sum_j 2 p*_ij e_ij W' V_i V_j in the list's gradient unit. `facing`, `others_facing`: of i
/// and of all particles of the other liquid.
template <Riemann R, int Dim>
inline void addLiquidPressure(const Interface& interface, const NeighborList<Dim>& list,
                              std::size_t i, const PairState<Dim>& own,
                              const PairState<Dim>* others, const Vec<Dim>& facing,
                              const Vec<Dim>* others_facing, ExactSums<Dim>& sum) {
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const PairLanes<Dim> other = gather(others, pair.index);
        Lanes v_ij[Dim], n[Dim];
        gatherVectors<Dim>(others_facing, pair.index, n);
        for (int c = 0; c < Dim; ++c) {
            v_ij[c] = own.v[c] - other.v[c];
            n[c] = facing[c] - n[c];
        }
        const Lanes closing = dot<Dim>(v_ij, n) * inverseSqrtLanes(dot<Dim>(n, n) + lanes(1e-30));
        const Lanes p2 =
            twiceInterfacePressure<R, Lanes>(interface, closing, lanes(own.p), other.p);
        const Lanes f = p2 * (own.V * other.V);
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, pair.gradient[c]);
    });
}

/// Adds sum_j 2 (v_i - v*_ij) . e_ij W' V_j in the list's gradient unit.
template <int Dim>
inline void addLiquidClosure(const Interface& interface, const NeighborList<Dim>& list,
                             std::size_t i, const Vec<Dim>& v, const Field<Vec<Dim>>& velocity,
                             const Field<double>& volume, ExactSum& sum) {
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        Lanes v_ij[Dim];
        gatherVectors<Dim>(velocity.data(), pair.index, v_ij);
        for (int c = 0; c < Dim; ++c) v_ij[c] = v[c] - v_ij[c];
        sum.addProduct(interfaceClosingRate<Dim, Lanes>(interface, pair, v_ij),
                       gatherLanes(volume.data(), pair.index));
    });
}

}  // namespace sphinx::dynamics::fluid
