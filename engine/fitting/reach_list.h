// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/parallel.h"
#include "core/types.h"
#include "neighbors/cell_grid.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sphinx::fitting {

/// Which particles, and which pieces of what lies outside of them, are in reach of each particle,
/// with some room, so that the list holds for many steps of a relaxation.
template <int Dim>
class ReachList {
 public:
    /// `room`: how much farther than the reach the list looks. Lengths.
    ReachList(double reach, double room, const std::vector<Vec<Dim>>& outside);

    /// Builds the list anew where the particles have left their room, or are others.
    void update(const AlignedVector<Vec<Dim>>& position);

    /// Calls use(i, neighbors, count) for the particles which, or of whose neighbors any, have
    /// moved; for all where the list is new. Numbers of neighbors from the number of particles on
    /// are pieces of the outside; their count is a multiple of eight, filled up with i itself.
    template <class Use>
    void forEachStirred(const AlignedVector<std::uint8_t>& moved, Use&& use);

 private:
    /// Lists of the particles of some cells, one after the other.
    struct Block {
        AlignedVector<Index> neighbors;
        AlignedVector<std::uint32_t> count;  // by particle of the grid's order, in eights
    };
    static constexpr std::size_t cells_of_block = 16;

    void build(const AlignedVector<Vec<Dim>>& position);
    void fill(Block& block, std::size_t first, std::size_t last);
    void findStirred(const AlignedVector<std::uint8_t>& moved);

    double reach_;
    double room_;
    double cell_size_;
    neighbors::CellGrid<Dim> particles_;  // where they stood when the list was built
    neighbors::CellGrid<Dim> outside_;
    AlignedVector<Vec<Dim>> built_at_;
    std::vector<Block> blocks_;
    bool fresh_ = true;                    // nothing has been found with this list yet
    AlignedVector<std::uint8_t> moving_;   // cells in which a particle has moved
    AlignedVector<std::uint8_t> stirred_;  // cells in reach of one
};

template <int Dim>
template <class Use>
void ReachList<Dim>::forEachStirred(const AlignedVector<std::uint8_t>& moved, Use&& use) {
    findStirred(moved);
    parallelFor(
        blocks_.size(),
        [&](std::size_t b) {
            const Block& block = blocks_[b];
            const Index* neighbors = block.neighbors.data();
            const std::uint32_t* count = block.count.data();
            const std::size_t last = std::min((b + 1) * cells_of_block, particles_.cells());
            for (std::size_t cell = b * cells_of_block; cell < last; ++cell)
                for (std::size_t s = particles_.start(cell); s < particles_.start(cell + 1); ++s) {
                    const std::size_t n = lane_count * std::size_t{*count++};
                    if (stirred_[cell]) use(particles_.order()[s], neighbors, n);
                    neighbors += n;
                }
        },
        1);
}

extern template class ReachList<2>;
extern template class ReachList<3>;

}  // namespace sphinx::fitting
