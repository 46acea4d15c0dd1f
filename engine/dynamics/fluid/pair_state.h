// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/lanes.h"
#include "core/types.h"

namespace sphinx::dynamics::fluid {

/// What the pair terms of the acoustic step read of a neighbor, packed so that it costs one cache
/// line: v, p, V.
template <int Dim>
struct alignas(Dim == 2 ? 32 : 64) PairState {
    static constexpr int stride = Dim == 2 ? 4 : 8;

    double v[Dim];  ///< velocity
    double p;       ///< pressure
    double V;       ///< volume
};

/// The same of eight neighbors.
template <int Dim>
struct PairLanes {
    Lanes v[Dim];
    Lanes p;
    Lanes V;
};

template <int Dim>
[[gnu::always_inline]] inline PairLanes<Dim> gather(const PairState<Dim>* state,
                                                    const std::uint32_t* index) {
    const double* base = state->v;
    Lanes r[4];
    gatherRecords<PairState<Dim>::stride>(base, index, r);
    PairLanes<Dim> out;
    for (int c = 0; c < Dim; ++c) out.v[c] = r[c];
    out.p = r[Dim];
    if constexpr (Dim == 2) {
        out.V = r[3];
    } else {
        constexpr std::size_t s = PairState<Dim>::stride;
        const double* V = base + Dim + 1;
        out.V = Lanes{V[s * index[0]], V[s * index[1]], V[s * index[2]], V[s * index[3]],
                      V[s * index[4]], V[s * index[5]], V[s * index[6]], V[s * index[7]]};
    }
    return out;
}

}  // namespace sphinx::dynamics::fluid
