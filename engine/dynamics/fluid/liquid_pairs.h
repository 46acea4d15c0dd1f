// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums over the particles of another liquid near one of a fluid, eight pairs at a time. Each liquid
// sums its own side: of the same numbers, so what one gets the other loses.

#include "core/exact_sum.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/terms/interface.h"
#include "dynamics/pair_loop.h"

namespace sphinx::dynamics::fluid {

/// Adds sum_j 2 p*_ij e_ij W' V_i V_j in the list's gradient unit.
template <Riemann R, int Dim>
inline void addLiquidPressure(const Interface& interface, const NeighborList<Dim>& list,
                              std::size_t i, const PairState<Dim>& own,
                              const PairState<Dim>* others, ExactSums<Dim>& sum) {
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const PairLanes<Dim> other = gather(others, pair.index);
        Lanes v_ij[Dim];
        for (int c = 0; c < Dim; ++c) v_ij[c] = own.v[c] - other.v[c];
        const Lanes p2 =
            twiceInterfacePressure<R, Dim, Lanes>(interface, pair, v_ij, lanes(own.p), other.p);
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
