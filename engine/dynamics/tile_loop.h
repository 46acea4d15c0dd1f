// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/number.h"
#include "core/parallel.h"
#include "dynamics/pair.h"
#include "dynamics/words.h"
#include "neighbors/pair_tiles.h"

#include <algorithm>
#include <array>

// Sums over the pairs of a fluid's own particles, sixteen at a time (neighbors/pair_tiles.h). In
// files that fuse no product and sum.
namespace sphinx::dynamics {

/// What pair terms read of the particle in a slot, as floats in one half of a cache line. What the
/// numbers are measured in is up to who fills it, but of the size of 1. An empty slot has zeros.
template <int Dim>
struct alignas(32) TileRecord {
    std::int32_t place[Dim];
    float v[Dim];  ///< velocity
    float p;       ///< pressure
    float V;       ///< volume
    static constexpr int words = 2 * Dim + 2;
};

/// One for each slot, copies included.
template <int Dim>
class TileRecords {
 public:
    /// Makes room for, and writes the places of, the particles of the present tiles.
    void follow(const PairTiles<Dim>& tiles) {
        if (builds_ == tiles.builds()) return;
        builds_ = tiles.builds();
        records_.resize(tiles.slots());
        parallelFor(records_.size(), [&](std::size_t s) {
            records_[s] = {};
            for (std::size_t k = 0; k < Dim; ++k)
                records_[s].place[k] = tiles.place(static_cast<Index>(s)).whole[k];
        });
    }
    /// write(record, i) for all particles, then copies get what was written.
    template <class Write>
    void fill(const PairTiles<Dim>& tiles, Write&& write) {
        const Index* particles = tiles.particles();
        TileRecord<Dim>* records = records_.data();
        parallelRanges(tiles.firstCopy(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s)
                if (particles[s] != PairTiles<Dim>::none) write(records[s], particles[s]);
        });
        updateCopies(tiles);
    }
    void updateCopies(const PairTiles<Dim>& tiles) {
        for (Index slot = tiles.firstCopy(); slot < tiles.slots(); ++slot) {
            const Index original = tiles.original(slot);
            if (original == PairTiles<Dim>::none) continue;
            const auto place = std::to_array(records_[slot].place);
            records_[slot] = records_[original];
            std::ranges::copy(place, records_[slot].place);
        }
    }
    TileRecord<Dim>* data() { return records_.data(); }
    TileRecord<Dim>& operator[](Index slot) { return records_[slot]; }
    const TileRecord<Dim>& operator[](Index slot) const { return records_[slot]; }
    const float* words() const { return reinterpret_cast<const float*>(records_.data()); }

 private:
    std::uint64_t builds_ = 0;
    AlignedVector<TileRecord<Dim>> records_;
};

/// Either side of the pairs of a tile.
template <int Dim>
struct TileSide {
    WholeTile place[Dim];
    FloatTile v[Dim], p, V;
};

namespace detail {
template <int Dim, class Spread>
[[gnu::always_inline]] inline TileSide<Dim> loadSide(const float* words, const std::uint32_t* slots,
                                                     Spread&& spread) {
    FloatQuad quads[8];
    gatherWords<TileRecord<Dim>::words>(words, slots, quads);
    TileSide<Dim> side;
    for (int c = 0; c < Dim; ++c) {
        side.place[c] = reinterpret_cast<WholeTile>(spread(quads[c]));
        side.v[c] = spread(quads[Dim + c]);
    }
    side.p = spread(quads[2 * Dim]);
    side.V = spread(quads[2 * Dim + 1]);
    return side;
}
}  // namespace detail

/// Sixteen pairs: gradient and dW in a unit of which each pair has `weight`, so a term that is
/// linear in them is multiplied by it once. It is 0 where there is no pair.
template <int Dim>
struct TilePairs : Pair<Dim, FloatTile> {
    FloatTile weight;
};

/// Terms that i and j get; what j gets is not asked for where the pair is seen from both sides.
enum class Reaction {
    opposite,  ///< minus what i gets
    own,       ///< given beside it
};

/// `N` sums for each particle of what term(i, j, pairs, on_i, on_j) gives, four particles i and j
/// at a time, each number of the size of 1 times `weight`.
template <int Dim, int N>
class TileSums {
 public:
    template <Reaction reaction, class Term>
    void add(const PairTiles<Dim>& tiles, const TileRecords<Dim>& records, Term&& term) {
        sums_.resize(sum_stride<N> * tiles.sumCount());
        const float* words = records.words();
        parallelFor(
            tiles.chunks().size(),
            [&](std::size_t c) { addChunk<reaction>(tiles.chunks()[c], words, term); }, 1);
    }
    /// f(particle, slot, sums) for all particles, after add().
    template <class Function>
    void forEach(const PairTiles<Dim>& tiles, Function&& f) {
        parallelFor(
            tiles.chunks().size(),
            [&](std::size_t c) {
                const auto& chunk = tiles.chunks()[c];
                tiles.gather(chunk, sum_stride<N>, sums_.data());
                const ExactNumber* sums = tiles.sumsOf(chunk, sum_stride<N>, sums_.data());
                const Index* particles = tiles.particles();
                for (Index slot = chunk.first_slot; slot < chunk.end_slot; ++slot) {
                    const Index i = particles[slot];
                    if (i == PairTiles<Dim>::none) continue;
                    f(i, slot, sums + sum_stride<N> * std::size_t{slot});
                }
            },
            1);
    }

 private:
    template <Reaction reaction, class Term>
    void addChunk(const typename PairTiles<Dim>::Chunk& chunk, const float* words, Term& term) {
        ExactNumber* sums = PairTiles<Dim>::sumsOf(chunk, sum_stride<N>, sums_.data());
        std::fill(sums + sum_stride<N> * std::size_t{chunk.first_slot},
                  sums + sum_stride<N> * std::size_t{chunk.reach_end}, ExactNumber{});
        const std::uint32_t* j = chunk.j.data();
        const float* weight = chunk.weight.data();
        for (std::size_t c = 0; c + 1 < chunk.ranges.size(); ++c) {
            const Index first = chunk.first_slot + static_cast<Index>(c) * tile_side;
            const std::uint32_t own[tile_side] = {first, first + 1, first + 2, first + 3};
            const auto i = detail::loadSide<Dim>(words, own, ofEachI);
            ExactTile sum[N] = {};
            const auto tile = [&](FloatTile(&on_j)[N]) {
                const auto other = detail::loadSide<Dim>(words, j, ofEachJ);
                TilePairs<Dim> pairs;
                for (int k = 0; k < Dim; ++k)
                    pairs.gradient[k] = toFloat(other.place[k] - i.place[k]);
                const FloatTile r2 = dot<Dim>(pairs.gradient, pairs.gradient);
                pairs.inverse_dW = inverseSqrtTile(r2 + 1e-30f);
                pairs.dW = r2 * pairs.inverse_dW;
                pairs.weight = loadTile(weight);
                FloatTile on_i[N];
                term(i, other, pairs, on_i, on_j);
                std::array<ExactTile, N> exact;
                for (int n = 0; n < N; ++n) {
                    exact[n] = ExactTile(on_i[n]);
                    sum[n] += exact[n];
                }
                weight += tile_size;
                return exact;
            };
            const std::uint32_t two_sided = chunk.ranges[c].two_sided;
            const std::uint32_t end = chunk.ranges[c + 1].one_sided;
            std::uint32_t t = chunk.ranges[c].one_sided;
            FloatTile on_j[N];
            for (; t < two_sided; ++t, j += tile_side) tile(on_j);
            for (; t < end; ++t, j += tile_side) {
                const auto exact = tile(on_j);
                ExactTile given[N];
                for (int n = 0; n < N; ++n)
                    given[n] = reaction == Reaction::opposite ? exact[n] : ExactTile(on_j[n]);
                addOverI<N, reaction == Reaction::opposite ? -1 : 1>(given, j, sums);
            }
            addOverJ<N>(sum, sums + sum_stride<N> * std::size_t{first});
        }
    }

    AlignedVector<ExactNumber> sums_;
};

}  // namespace sphinx::dynamics
