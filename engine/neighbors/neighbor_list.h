// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"

#include <cstdint>
#include <span>

namespace sphinx::neighbors {

/// Eight neighbors of one particle. gradient = e_ij W'(r_ij), e_ij = (r_i - r_j)/r_ij, so it is the
/// gradient of W with respect to the particle's own position, in units of the list's gradient_unit.
/// Places beyond the last neighbor repeat an index and carry a zero gradient.
/// Number is double for lists of the reference configuration and a whole number for lists that
/// follow the motion: half the memory, and 100 times as fine as float, in which a last bit of a
/// position that tips the rounding of a gradient becomes 1e-7. (Sums are in double; e W' alone is
/// antisymmetric to the last bit.)
template <int Dim, class Number>
struct alignas(32) PairBlock {
    std::uint32_t index[lane_count];
    Number gradient[Dim][lane_count];
};

/// What a list keeps besides neighbors and gradients.
struct Keeps {
    bool distance = false;
    bool kernel_sum = false;
};

/// Neighbors in body `to` of every particle of body `from`, r < cutoff, the particle itself left
/// out.
template <int Dim, class Number = std::int32_t>
struct NeighborList {
    using Block = PairBlock<Dim, Number>;
    struct Range {
        std::uint64_t first = 0;  ///< index of the first block
        std::uint32_t blocks = 0;
        std::uint32_t count = 0;  ///< neighbors
    };

    double cutoff = 0;         ///< length
    double gradient_unit = 1;  ///< 1/length^(Dim+1); 1 where gradients are stored in double
    AlignedVector<Range> ranges;
    AlignedVector<Block> blocks;
    Keeps keeps;
    /// r_ij, eight per block, if kept, in units of distanceUnit().
    AlignedVector<std::int32_t> distance;
    /// Sum over the neighbors of W(r_ij), if kept. 1/length^Dim.
    AlignedVector<double> kernel_sum;

    std::span<const Block> of(std::size_t i) const {
        return {blocks.data() + ranges[i].first, ranges[i].blocks};
    }
    const std::int32_t* distancesOf(std::size_t i) const {
        return distance.data() + ranges[i].first * lane_count;
    }
    /// Length. Of it all distances below the cutoff are whole numbers below 2^31.
    double distanceUnit() const { return cutoff / 2147483000; }
    std::size_t bytes() const {
        return ranges.capacity() * sizeof(Range) + blocks.capacity() * sizeof(Block) +
               4 * distance.capacity() + 8 * kernel_sum.capacity();
    }
};

}  // namespace sphinx::neighbors
