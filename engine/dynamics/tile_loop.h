// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/number.h"
#include "core/parallel.h"
#include "dynamics/group.h"
#include "dynamics/pair.h"
#include "dynamics/words.h"
#include "neighbors/pair_tiles.h"

#include <algorithm>
#include <array>
#include <tuple>

// Sums over the pairs of a fluid's own particles, sixteen at a time (neighbors/pair_tiles.h). In
// files that fuse no product and sum.
namespace sphinx::dynamics {

/// Where a particle stands, as wide as the numbers beside it: in units of PairTiles, with what
/// rounding has left where there is room for it.
template <class Real>
struct PlaceWord {
    std::int32_t whole;
};
template <>
struct PlaceWord<double> {
    std::int32_t whole;
    float rest;
};

/// What pair terms read of the particle in a slot, in one half of a cache line, of doubles in a
/// whole one. What the numbers are measured in is up to who fills it, but of the size of 1. An
/// empty slot has zeros.
template <int Dim, class Real>
struct alignas(8 * sizeof(Real)) TileRecord {
    PlaceWord<Real> place[Dim];
    Real v[Dim];  ///< velocity
    Real p;       ///< pressure
    Real V;       ///< volume
    static constexpr int words = 2 * Dim + 2;
};

/// One for each slot, copies included, in the precision of the tiles.
template <int Dim>
class TileRecords {
 public:
    /// Makes room for, and writes the places of, the particles of the present tiles.
    void follow(const PairTiles<Dim>& tiles) {
        if (builds_ == tiles.builds()) return;
        builds_ = tiles.builds();
        withPrecision(tiles.precision(), [&]<class Real>() {
            auto& records = of<Real>();
            makeRoom(records, tiles.slots());
            parallelFor(records.size(), [&](std::size_t s) {
                records[s] = {};
                const auto& place = tiles.place(static_cast<Index>(s));
                for (std::size_t k = 0; k < Dim; ++k) {
                    records[s].place[k].whole = place.whole[k];
                    if constexpr (std::is_same_v<Real, double>)
                        records[s].place[k].rest = place.rest[k];
                }
            });
        });
    }
    /// Writes what a group of particles has; copies get it by updateCopies().
    template <class Real>
    [[gnu::always_inline]] void put(const PairTiles<Dim>& tiles, const Group& group,
                                    const VecOf<Dim, Wide>& v, Wide p, Wide V) {
        const Index* slots = tiles.slotsOf() + group.first;
        TileRecord<Dim, Real>* records = data<Real>();
        double first[4 * lane_count], volumes[lane_count];
        if constexpr (Dim == 2) {
            const Lanes words[4] = {v[0].at, v[1].at, p.at, V.at};
            storeRecords<4>(words, first);
        } else {
            const Lanes words[4] = {v[0].at, v[1].at, v[2].at, p.at};
            storeRecords<4>(words, first);
            storeLanes(V.at, volumes);
        }
        for (std::size_t k = 0; k < group.count; ++k) {
            // v, p and V stand one after the other.
            TileRecord<Dim, Real>& record = records[slots[k]];
            DoubleQuad words;
            std::memcpy(&words, first + 4 * k, sizeof words);
            const auto rounded = __builtin_convertvector(words, QuadOf<Real>);
            std::memcpy(&record.v, &rounded, sizeof rounded);
            if constexpr (Dim == 3) record.V = static_cast<Real>(volumes[k]);
        }
    }
    /// write(record, i) for all particles, then copies get what was written.
    template <class Real, class Write>
    void fill(const PairTiles<Dim>& tiles, Write&& write) {
        const Index* particles = tiles.particles();
        TileRecord<Dim, Real>* records = data<Real>();
        parallelRanges(tiles.firstCopy(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s)
                if (particles[s] != PairTiles<Dim>::none) write(records[s], particles[s]);
        });
        updateCopies<Real>(tiles);
    }
    template <class Real>
    void updateCopies(const PairTiles<Dim>& tiles) {
        TileRecord<Dim, Real>* records = data<Real>();
        for (Index slot = tiles.firstCopy(); slot < tiles.slots(); ++slot) {
            const Index original = tiles.original(slot);
            if (original == PairTiles<Dim>::none) continue;
            const auto place = std::to_array(records[slot].place);
            records[slot] = records[original];
            std::ranges::copy(place, records[slot].place);
        }
    }
    template <class Real>
    TileRecord<Dim, Real>* data() {
        return of<Real>().data();
    }
    template <class Real>
    const Real* words() const {
        return reinterpret_cast<const Real*>(
            std::get<AlignedVector<TileRecord<Dim, Real>>>(records_).data());
    }

 private:
    template <class Real>
    auto& of() {
        return std::get<AlignedVector<TileRecord<Dim, Real>>>(records_);
    }

    std::uint64_t builds_ = 0;
    std::tuple<AlignedVector<TileRecord<Dim, float>>, AlignedVector<TileRecord<Dim, double>>>
        records_;
};

/// Either side of the pairs of a tile.
template <int Dim, class Real>
struct TileSide {
    TileOf<Real> place[Dim];  // as stored
    TileOf<Real> v[Dim], p, V;

    explicit TileSide(const TileOf<Real> (&words)[8]) : p(words[2 * Dim]), V(words[2 * Dim + 1]) {
        for (int c = 0; c < Dim; ++c) {
            place[c] = words[c];
            v[c] = words[Dim + c];
        }
    }
};

namespace detail {
template <Of side, int Dim, class Real>
[[gnu::always_inline]] inline TileSide<Dim, Real> loadSide(const Real* records,
                                                           const std::uint32_t* slots) {
    TileOf<Real> words[8];
    gatherOfEach<side, TileRecord<Dim, Real>::words>(records, slots, words);
    return TileSide<Dim, Real>(words);
}
/// How far j stands from i, in units of place.
[[gnu::always_inline]] inline FloatTile placeDifference(FloatTile i, FloatTile j) {
    return toFloat(
        wrappedDifference(reinterpret_cast<WholeTile>(j), reinterpret_cast<WholeTile>(i)));
}
[[gnu::always_inline]] inline DoubleTile placeDifference(const DoubleTile& i, const DoubleTile& j) {
    const auto half = [](Lanes a, Lanes b) -> Lanes {
        const WholeTile whole =
            wrappedDifference(reinterpret_cast<WholeTile>(b), reinterpret_cast<WholeTile>(a));
        const auto rest = [](Lanes c) {
            const auto words = reinterpret_cast<FloatTile>(c);
            return toLanes(__builtin_shufflevector(words, words, 1, 3, 5, 7, 9, 11, 13, 15));
        };
        return lowLanes(__builtin_shufflevector(whole, whole, 0, 2, 4, 6, 8, 10, 12, 14, 0, 2, 4, 6,
                                                8, 10, 12, 14)) +
               (rest(b) - rest(a));
    };
    return {half(i.low, j.low), half(i.high, j.high)};
}
}  // namespace detail

/// Sixteen pairs: gradient and dW in a unit of which each pair has `weight`, so a term that is
/// linear in them is multiplied by it once. It is 0 where there is no pair.
template <int Dim, class Real>
struct TilePairs : Pair<Dim, TileOf<Real>> {
    TileOf<Real> weight;
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
    template <Reaction reaction, class Real, class Term>
    void add(const PairTiles<Dim>& tiles, const TileRecords<Dim>& records, Term&& term) {
        makeRoom(sums_, sum_stride<N> * tiles.sumCount());
        const Real* words = records.template words<Real>();
        parallelFor(
            tiles.chunks().size(),
            [&](std::size_t c) { addChunk<reaction, Real>(tiles.chunks()[c], words, term); }, 1);
    }
    /// After add(): f(group, sums) for the n particles, eight at a time; sums are in the unit that
    /// is `unit` of one. Before, also(i, sums) adds what else there is for the particles `some`,
    /// which ascend.
    template <class Also, class Function>
    void forEach(const PairTiles<Dim>& tiles, std::size_t n, double unit,
                 const std::vector<Index>& some, Also&& also, Function&& f) {
        const auto& chunks = tiles.chunks();
        if (chunks.size() > 1)
            parallelFor(
                chunks.size(),
                [&](std::size_t c) { tiles.gather(chunks[c], sum_stride<N>, sums_.data()); }, 1);
        parallelRanges(
            groupCount(n),
            [&](std::size_t begin, std::size_t end) __attribute__((flatten)) {
                auto next = std::ranges::lower_bound(some, begin * lane_count);
                for (std::size_t number = begin; number < end; ++number) {
                    const Group group = groupOf(number, n);
                    VecOf<N, Wide> sums = load(tiles.sumPlaces() + group.first, unit);
                    const std::size_t group_end = group.first + group.count;
                    for (; next != some.end() && *next < group_end; ++next) {
                        const std::size_t k = *next - group.first;
                        std::array<double, N> one;
                        for (int m = 0; m < N; ++m) one[m] = sums[m][k];
                        also(*next, one);
                        for (int m = 0; m < N; ++m) sums[m].at[k] = one[m];
                    }
                    f(group, sums);
                }
            },
            default_grain / lane_count);
    }

 private:
    template <Reaction reaction, class Real, class Term>
    void addChunk(const typename PairTiles<Dim>::Chunk& chunk, const Real* words, Term& term) {
        using Tile = TileOf<Real>;
        ExactNumber* sums = PairTiles<Dim>::sumsOf(chunk, sum_stride<N>, sums_.data());
        std::fill(sums + sum_stride<N> * std::size_t{chunk.first_slot},
                  sums + sum_stride<N> * std::size_t{chunk.reach_end}, ExactNumber{});
        const std::uint32_t* j = chunk.j.data();
        const Real* weight = chunk.template weights<Real>().data();
        for (std::size_t c = 0; c + 1 < chunk.ranges.size(); ++c) {
            const Index first = chunk.first_slot + static_cast<Index>(c) * tile_side;
            const std::uint32_t own[tile_side] = {first, first + 1, first + 2, first + 3};
            const auto i = detail::loadSide<Of::i, Dim>(words, own);
            ExactTile sum[N] = {};
            const auto tile = [&](Tile(&on_j)[N]) __attribute__((always_inline)) {
                __builtin_prefetch(weight + 16 * tile_size);  // weights are read once a sum
                const auto other = detail::loadSide<Of::j, Dim>(words, j);
                TilePairs<Dim, Real> pairs;
                for (int k = 0; k < Dim; ++k)
                    pairs.gradient[k] = detail::placeDifference(i.place[k], other.place[k]);
                const Tile r2 = dot<Dim>(pairs.gradient, pairs.gradient);
                pairs.inverse_dW = inverseSqrtTile(static_cast<Real>(1e-30) + r2);
                pairs.dW = r2 * pairs.inverse_dW;
                pairs.weight = loadTile(weight);
                Tile on_i[N];
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
            Tile on_j[N];
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

    /// Of the eight particles whose sums stand at these places.
    [[gnu::always_inline]] VecOf<N, Wide> load(const Index* places, double unit) const {
        VecOf<N, Wide> sums;
        const auto set = [&](int m, ExactLanes exact) { sums[m] = unit * fromExact(exact); };
        if constexpr (N == 1) {
            const auto at = [&](int k) { return sums_[places[k]]; };
            set(0, ExactLanes{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)});
        } else {
            // In a row, of which loadRecords() makes components.
            double rows[sum_stride<N> * lane_count];
            for (std::size_t k = 0; k < lane_count; ++k)
                std::memcpy(rows + sum_stride<N> * k,
                            sums_.data() + sum_stride<N> * std::size_t{places[k]},
                            sum_stride<N> * sizeof(double));
            Lanes words[4];
            loadRecords<sum_stride<N>>(rows, words);
            for (int m = 0; m < N; ++m) set(m, reinterpret_cast<ExactLanes>(words[m]));
        }
        return sums;
    }

    AlignedVector<ExactNumber> sums_;
};

}  // namespace sphinx::dynamics
