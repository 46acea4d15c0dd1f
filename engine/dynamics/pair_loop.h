// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"
#include "dynamics/pair.h"
#include "dynamics/words.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics {

/// Vectors of eight particles by components.
template <int Dim>
inline void gatherVectors(const Vec<Dim>* values, const std::uint32_t* index, Lanes (&out)[Dim]) {
    if constexpr (Dim == 2) {
        gatherPairs(values->data(), index, out);
    } else {
        gatherTriples(values->data(), index, out);
    }
}

/// Distances of particle i from its neighbors, block by block.
template <int Dim>
class Distances {
 public:
    Distances(const NeighborList<Dim>& list, std::size_t i)
        : at_(list.distancesOf(i)), unit_(list.distanceUnit()) {}
    /// Of the next eight.
    Lanes next() {
        const Lanes r = unit_ * loadLanes(at_);
        at_ += lane_count;
        return r;
    }

 private:
    const std::int32_t* at_;
    double unit_;
};

/// Eight pairs of particle i with neighbors j: gradients in the list's gradient_unit.
template <int Dim>
struct Pairs : Pair<Dim, Lanes> {
    const std::uint32_t* index;  ///< j
};

/// Asks for the blocks of the particle that a loop meets some hundred nanoseconds after i, one at a
/// time: lists are too long for the caches, and particles need not stand in the lists' order.
template <int Dim>
class Prefetch {
 public:
    Prefetch(const NeighborList<Dim>& list, std::size_t i) {
        constexpr std::size_t ahead = Dim == 2 ? 8 : 3;
        const std::size_t later = std::min(i + ahead, list.ranges.size() - 1);
        next_ = reinterpret_cast<std::uintptr_t>(list.blocks.data()) +
                list.ranges[later].first * block_size;
    }
    void next() {
        constexpr std::uintptr_t cache_line = 64;
        for (std::uintptr_t byte = 0; byte < block_size; byte += cache_line)
            __builtin_prefetch(reinterpret_cast<const void*>(next_ + byte));
        next_ += block_size;
    }

 private:
    static constexpr std::uintptr_t block_size = sizeof(typename NeighborList<Dim>::Block);
    std::uintptr_t next_;
};

/// term(Pairs) for all neighbors of i, eight at a time. Unused places have a zero gradient, so a
/// term that is linear in the gradient needs no mask.
template <int Dim, class Term>
inline void forEachPair(const NeighborList<Dim>& list, std::size_t i, Term&& term) {
    Prefetch<Dim> prefetch(list, i);
    for (const auto& block : list.of(i)) {
        prefetch.next();
        Pairs<Dim> pairs;
        pairs.index = block.index;
        for (int c = 0; c < Dim; ++c) pairs.gradient[c] = loadLanes(block.gradient[c]);
        const Lanes norm2 = dot<Dim>(pairs.gradient, pairs.gradient);
        pairs.inverse_dW = inverseSqrtLanes(norm2 + 1e-30);
        pairs.dW = norm2 * pairs.inverse_dW;
        term(pairs);
    }
}

}  // namespace sphinx::dynamics
