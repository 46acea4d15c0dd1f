// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/support.h"

#include "neighbors/pair_tiles.h"

#include <atomic>

namespace sphinx::dynamics::fluid {

template <int Dim>
void Support<Dim>::findSurface(std::size_t particles) {
    lacks_.assign(self_->slots() + 3, 0);  // anyOf() reads beyond the last
    told_.assign(self_->slots(), 0);
    parallelForGroups(particles, [&](const Group& group) {
        const LaneMask lacks = isLacking(share(group));
        for (std::size_t k = 0; k < group.count; ++k)
            lacks_[self_->slotsOf()[group.first + k]] = lacks[k] != 0;
    });
    for (Index slot = self_->firstCopy(); slot < self_->slots(); ++slot) {
        const Index original = self_->original(slot);
        lacks_[slot] = original != PairTiles<Dim>::none && lacks_[original] != 0;
    }
    const auto tell = [&](Index slot) {  // several threads may say the same
        std::atomic_ref(told_[slot]).store(1, std::memory_order_relaxed);
    };
    self_->forEachCluster(
        [&](Index first, const std::uint32_t* j, std::size_t count, auto&& pairs) {
            const std::uint8_t* i_lacks = lacks_.data() + first;
            const bool any_i = (i_lacks[0] | i_lacks[1] | i_lacks[2] | i_lacks[3]) != 0;
            if (!any_i && !anyOf(lacks_.data(), j, count)) return;
            // Lane 4 i + j is the pair of i and j.
            unsigned of_lacking_i = 0;
            for (int k = 0; k < tile_side; ++k)
                if (i_lacks[k] != 0) of_lacking_i |= 0xfu << (tile_side * k);
            unsigned i_told = 0;  // lanes
            for (std::size_t tile = 0; tile_side * tile < count; ++tile, j += tile_side) {
                const unsigned of_lacking_j = lacks_[j[0]] * 0x1111u | lacks_[j[1]] * 0x2222u |
                                              lacks_[j[2]] * 0x4444u | lacks_[j[3]] * 0x8888u;
                if ((of_lacking_i | of_lacking_j) == 0) continue;
                const unsigned all = pairs(tile);
                i_told |= all & of_lacking_j;
                const unsigned j_told = all & of_lacking_i;
                if (j_told == 0) continue;
                for (int k = 0; k < tile_side; ++k)
                    if ((j_told & (0x1111u << k)) != 0) tell(j[k]);
            }
            for (int k = 0; k < tile_side; ++k)
                if ((i_told & (0xfu << (tile_side * k))) != 0) tell(first + static_cast<Index>(k));
        });
    for (const Term& term : terms_)
        if (term.fluid) hearFrom(term);
}

/// Particles with a neighbor in another fluid that lacks support.
template <int Dim>
void Support<Dim>::hearFrom(const Term& term) {
    const Support& other = *term.fluid;
    AlignedVector<std::uint8_t> lacks(term.relation->to->size());
    parallelForGroups(lacks.size(), [&](const Group& group) {
        const LaneMask lacking = other.isLacking(other.share(group));
        for (std::size_t k = 0; k < group.count; ++k) lacks[group.first + k] = lacking[k] != 0;
    });
    const NeighborList<Dim>& list = term.relation->list;
    parallelFor(list.ranges.size(), [&](std::size_t i) {
        for (const auto& block : list.of(i))
            for (const std::uint32_t j : block.index)  // beyond the last one repeats
                if (lacks[j] != 0) told_[self_->slotsOf()[i]] = 1;
    });
}

template class Support<2>;
template class Support<3>;

}  // namespace sphinx::dynamics::fluid
