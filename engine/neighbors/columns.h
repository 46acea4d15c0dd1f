// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/tile.h"
#include "core/types.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sphinx::neighbors {

/// Throws PhysicsError when a position is not finite.
template <int Dim>
Box<Dim> boundsOf(const Vec<Dim>* position, std::size_t n);

/// Points in columns along the first axis (a lattice is made in rows along it), in each by bins of
/// half a spacing; within a bin they stand in storage order. In this order they fill slots, four of
/// which make a cluster: the columns are so wide that a cluster is about as long as it is wide.
/// Slots are left empty where a column ends, and where four points would stand too far apart.
template <int Dim>
class Columns {
 public:
    static constexpr Index none = ~Index{0};

    /// Coordinates of slots are taken from the origin `frame`, in cutoffs; the points lie within
    /// `bounds`.
    void build(const Vec<Dim>* points, std::size_t n, const Box<Dim>& bounds, const Vec<Dim>& frame,
               double spacing, double cutoff);

    /// The points in the order of the slots.
    const AlignedVector<Index>& order() const { return order_; }
    Index slots() const { return slots_; }
    /// The point in a slot, or none.
    Index point(Index slot) const { return point_[slot]; }
    const Index* points() const { return point_.data(); }
    std::size_t bytes() const;

    /// Where the points of one cluster stand.
    struct Cluster {
        FloatTile x[Dim][tile_side];  ///< each of them, in all lanes
        float lower[Dim], upper[Dim];
    };
    Cluster cluster(Index first_slot) const;
    /// Writes base + slot for all points, in slots from `from` on, that are nearer than `reach`
    /// (in cutoffs) to one of the cluster's; returns how many. `column`: the first in which to
    /// look. Writes up to fifteen places beyond.
    template <bool LaterOnly>
    Index findNear(const Cluster& cluster, Index from, float reach, Index base,
                   AlignedVector<std::uint32_t>& out, Index count) const;

 private:
    static constexpr float far_away = 1e18f;  // cutoffs; the square is still finite

    float width_ = 1, bin_ = 1;
    std::array<float, Dim> offset_{};  // of the first column and bin in the frame
    std::array<int, Dim> counts_{};    // of bins along the first axis, of columns along the others
    Index slots_ = 0;
    AlignedVector<std::uint32_t> start_;  // first slot of each bin
    AlignedVector<Index> bin_of_;
    AlignedVector<Index> order_;
    AlignedVector<Index> point_;
    AlignedVector<std::uint32_t> column_of_;   // of a cluster
    std::array<AlignedVector<float>, Dim> x_;  // of a slot
};

template <int Dim>
typename Columns<Dim>::Cluster Columns<Dim>::cluster(Index first_slot) const {
    Cluster c;
    for (int k = 0; k < Dim; ++k) {
        const float* x = x_[k].data() + first_slot;
        c.lower[k] = c.upper[k] = x[0];  // never empty
        c.x[k][0] = tile(x[0]);
        for (int q = 1; q < tile_side; ++q) {
            const bool empty = point_[first_slot + static_cast<Index>(q)] == none;
            c.x[k][q] = tile(empty ? -far_away : x[q]);
            if (empty) continue;
            c.lower[k] = x[q] < c.lower[k] ? x[q] : c.lower[k];
            c.upper[k] = x[q] > c.upper[k] ? x[q] : c.upper[k];
        }
    }
    return c;
}

template <int Dim>
template <bool LaterOnly>
Index Columns<Dim>::findNear(const Cluster& cluster, Index from, float reach, Index base,
                             AlignedVector<std::uint32_t>& out, Index count) const {
    const float reach2 = reach * reach;
    const FloatTile limit = tile(reach2);
    float lower[Dim], upper[Dim];
    for (int k = 0; k < Dim; ++k) {
        lower[k] = cluster.lower[k] - offset_[k];
        upper[k] = cluster.upper[k] - offset_[k];
    }
    const float per_width = 1 / width_;
    const float per_bin = 1 / bin_;
    const auto first = [&](int k) {
        return std::max(0, static_cast<int>((lower[k] - reach) * per_width));
    };
    const auto end = [&](int k) {
        const float e = (upper[k] + reach) * per_width;
        return e < 0 ? 0 : std::min(counts_[k], static_cast<int>(e) + 1);
    };
    const auto apart = [&](int k, int column) {  // squared, along one axis
        const float a = static_cast<float>(column) * width_;
        const float d = std::max({0.0f, a - upper[k], lower[k] - (a + width_)});
        // The last column has what rounding has put beyond it.
        return column + 1 == counts_[k] && lower[k] > a ? 0.0f : d * d;
    };
    std::array<int, 2> own{-1, -1};
    if constexpr (LaterOnly) {
        const auto column = static_cast<int>(column_of_[from / tile_side - 1]);
        own = {column % counts_[1], column / counts_[1]};
    }
    const auto search = [&](int column, float rest) {
        const float z = std::sqrt(rest);
        const float top = (upper[0] + z) * per_bin;
        if (top < 0) return;
        const int a =
            std::min(counts_[0] - 1, std::max(0, static_cast<int>((lower[0] - z) * per_bin)));
        const int b = std::min(counts_[0] - 1, static_cast<int>(top));
        const std::uint32_t* start =
            start_.data() + static_cast<std::size_t>(column) * static_cast<std::size_t>(counts_[0]);
        std::uint32_t slot = start[a];
        const std::uint32_t stop = start[b + 1];
        if (LaterOnly && slot < from) slot = from;
        if (slot >= stop) return;
        if (out.size() < count + (stop - slot) + tile_size)
            out.resize(2 * (count + (stop - slot) + tile_size));
        for (; slot < stop; slot += tile_size) {
            FloatTile xj[Dim];
            for (int k = 0; k < Dim; ++k) xj[k] = loadTile(x_[k].data() + slot);
            FloatTile nearest = tile(far_away);
            for (int q = 0; q < tile_side; ++q) {
                FloatTile r2 = {};
                for (int k = 0; k < Dim; ++k) {
                    const FloatTile d = cluster.x[k][q] - xj[k];
                    r2 += d * d;
                }
                nearest = minTile(nearest, r2);
            }
            unsigned bits = lessBits(nearest, limit);
            if (stop - slot < tile_size) bits &= (1u << (stop - slot)) - 1;
            writePlaces(bits, base + slot, out.data() + count);
            count += static_cast<Index>(__builtin_popcount(bits));
        }
    };
    // Of the columns of one layer, which has `rest` left of the reach.
    const auto searchLayer = [&](int layer, float rest) {
        const int y_end = end(1);
        for (int y = layer == own[1] ? own[0] : first(1); y < y_end; ++y) {
            const float left = rest - apart(1, y);
            if (left > 0) search(layer * counts_[1] + y, left);
        }
    };
    if constexpr (Dim == 2) {
        searchLayer(0, reach2);
    } else {
        const int z_end = end(2);
        for (int z = LaterOnly ? own[1] : first(2); z < z_end; ++z) {
            const float rest = reach2 - apart(2, z);
            if (rest > 0) searchLayer(z, rest);
        }
    }
    return count;
}

extern template class Columns<2>;
extern template class Columns<3>;

}  // namespace sphinx::neighbors
