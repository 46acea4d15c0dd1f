// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/pair_tiles.h"

#include "core/number.h"
#include "core/parallel.h"
#include "neighbors/candidates.h"

#include <algorithm>
#include <cmath>

namespace sphinx::neighbors {
namespace {

/// Places are told apart within half the modulus, four cutoffs.
constexpr double places_of_cutoff = 0x1p29;
/// Of sums of w <= 1 over at most a thousand neighbors, and of sums of products with weights.
constexpr double kernel_scale = 0x1p41;
constexpr double weight_scale = 0x1p48;

template <int Dim>
typename PairTiles<Dim>::Place placeOf(const Vec<Dim>& x, double per_unit) {
    typename PairTiles<Dim>::Place place;
    for (int k = 0; k < Dim; ++k) {
        const double exact = x[k] * per_unit;
        const double whole = std::nearbyint(exact);
        place.whole[k] =
            static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)));
        place.rest[k] = static_cast<float>(exact - whole);
    }
    return place;
}

/// Entries for lanes beyond the last particle.
void repeatLast(AlignedVector<Index>& of_particles, std::size_t n) {
    for (std::size_t k = 0; k < lane_count; ++k) of_particles[n + k] = n ? of_particles[n - 1] : 0;
}

/// sigma/h^Dim: W of w.
template <int Dim>
double kernelUnit(const kernels::Kernel<Dim>& kernel) {
    const double h = kernel.smoothingLength();
    return kernels::withKernel<Dim>(kernel.type(), [&]<class K>() { return K::sigma; }) *
           std::pow(1 / h, Dim);
}

}  // namespace

template <int Dim>
void PairTiles<Dim>::build(const Vec<Dim>* position, std::size_t n,
                           const kernels::Kernel<Dim>& kernel, double spacing,
                           const bodies::Domain<Dim>& domain) {
    ++builds_;
    const double cutoff = kernel.cutoff();
    place_unit_ = cutoff / places_of_cutoff;
    gradient_unit_ = 1 / (weight_scale * std::pow(spacing, Dim + 1));
    const Box<Dim> bounds = boundsOf<Dim>(position, n);
    columns_.build(position, n, bounds, bounds.lower, spacing, cutoff);
    makeCopies(position, n, bounds, domain, spacing, cutoff);

    const double per_unit = 1 / place_unit_;
    makeRoom(places_, columns_.slots() + copy_columns_.slots());
    makeRoom(slot_of_, n + lane_count);
    parallelFor(columns_.slots(), [&](std::size_t s) {
        const Index i = columns_.point(static_cast<Index>(s));
        places_[s] = i == none ? Place{} : placeOf<Dim>(position[i], per_unit);
        if (i != none) slot_of_[i] = static_cast<Index>(s);
    });
    repeatLast(slot_of_, n);
    makeRoom(originals_, copy_columns_.slots());
    for (Index s = 0; s < copy_columns_.slots(); ++s) {
        const Index copy = copy_columns_.point(s);
        places_[columns_.slots() + s] = copy == none ? Place{} : copy_places_[copy];
        originals_[s] = copy == none ? none : slot_of_[copies_[copy]];
    }
    kernel_sum_.resize(n);
    divide();

    // In cutoffs, with what rounding of coordinates may hide.
    const double extent = n == 0 ? 0 : bounds.size().maxCoeff() / cutoff + 2;
    const auto reach = static_cast<float>(1 + 1e-5 + 0x1p-21 * extent);
    parallelFor(
        chunks_.size(), [&](std::size_t c) { findTiles(chunks_[c], reach); }, 1);
    sum_count_ = 0;
    for (Chunk& chunk : chunks_) {
        chunk.sums_at = sum_count_;
        sum_count_ += chunk.reach_end - chunk.first_slot;
    }
    makeRoom(sums_, sum_count_);
    if (chunks_.size() > 1) {
        makeRoom(sum_places_, n + lane_count);
        parallelFor(
            chunks_.size(),
            [&](std::size_t c) {
                const Chunk& chunk = chunks_[c];
                for (Index s = chunk.first_slot; s < chunk.end_slot; ++s)
                    if (columns_.point(s) != none)
                        sum_places_[columns_.point(s)] =
                            static_cast<Index>(chunk.sums_at + (s - chunk.first_slot));
            },
            1);
        repeatLast(sum_places_, n);
    }
    kernels::withKernel<Dim>(kernel.type(), [&]<class K>() {
        withPrecision(precision_, [&]<class Real>() {
            parallelFor(
                chunks_.size(),
                [&](std::size_t c) { weigh<K, Real>(chunks_[c], kernel, sums_.data()); }, 1);
        });
    });
    parallelFor(
        chunks_.size(),
        [&](std::size_t c) {
            const Chunk& chunk = chunks_[c];
            gather(chunk, 1, sums_.data());
            const ExactNumber* sums = sumsOf(chunk, 1, sums_.data());
            const double unit = kernelUnit(kernel) / kernel_scale;
            for (Index s = chunk.first_slot; s < chunk.end_slot; ++s)
                if (columns_.point(s) != none)
                    kernel_sum_[columns_.point(s)] = unit * fromExact(sums[s]);
        },
        1);
}

/// Images across periodic sides of particles that may be neighbors of one of the particles.
template <int Dim>
void PairTiles<Dim>::makeCopies(const Vec<Dim>* position, std::size_t n, const Box<Dim>& bounds,
                                const bodies::Domain<Dim>& domain, double spacing, double cutoff) {
    copies_.clear();
    copy_places_.clear();
    copy_positions_.clear();
    Box<Dim> around = bounds;
    around.lower.array() -= cutoff;
    around.upper.array() += cutoff;
    const double per_unit = 1 / place_unit_;
    Box<Dim> reached;
    const Images<Dim> images(domain);
    for (const Vec<Dim>& shift : images.shifts()) {
        if (shift.isZero(0)) continue;
        const Place shifted = placeOf<Dim>(shift, per_unit);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec<Dim> x = position[i] + shift;
            if (!around.contains(x)) continue;
            Place place = placeOf<Dim>(position[i], per_unit);
            for (int k = 0; k < Dim; ++k) {
                place.whole[k] =
                    static_cast<std::int32_t>(static_cast<std::uint32_t>(place.whole[k]) +
                                              static_cast<std::uint32_t>(shifted.whole[k]));
                place.rest[k] += shifted.rest[k];
            }
            copies_.push_back(static_cast<Index>(i));
            copy_places_.push_back(place);
            copy_positions_.push_back(x);
            reached.include(x);
        }
    }
    copy_columns_.build(copy_positions_.data(), copies_.size(), reached, bounds.lower, spacing,
                        cutoff);
}

/// Shares the clusters out to the threads.
template <int Dim>
void PairTiles<Dim>::divide() {
    constexpr std::size_t fewest = 64;
    const std::size_t clusters = columns_.slots() / tile_side;
    const std::size_t count =
        std::clamp<std::size_t>(clusters / fewest, std::min<std::size_t>(1, clusters),
                                static_cast<std::size_t>(threadCount()));
    chunks_.resize(count);
    for (std::size_t c = 0; c < count; ++c) {
        chunks_[c].first_slot = static_cast<Index>(clusters * c / count * tile_side);
        chunks_[c].end_slot = static_cast<Index>(clusters * (c + 1) / count * tile_side);
    }
}

template <int Dim>
void PairTiles<Dim>::findTiles(Chunk& chunk, float reach) const {
    chunk.ranges.clear();
    // More than most lists need; memory that nothing is written to costs nothing.
    const std::size_t room = (chunk.end_slot - chunk.first_slot) * std::size_t{Dim == 2 ? 8 : 32};
    if (chunk.j.size() < room) makeRoom(chunk.j, room);
    Index count = 0;
    Index farthest = chunk.end_slot;
    const auto fillUp = [&](Index first_slot) {
        if (chunk.j.size() < count + tile_side) chunk.j.resize(2 * (count + tile_side));
        // Places left over repeat a slot of the cluster and have no weight.
        for (; count % tile_side != 0; ++count) chunk.j[count] = first_slot;
    };
    for (Index s = chunk.first_slot; s < chunk.end_slot; s += tile_side) {
        const auto cluster = columns_.cluster(s);
        Range range;
        range.one_sided = count / tile_side;
        fillUp(s);
        for (Index q = 0; q < tile_side; ++q) chunk.j[count++] = s + q;
        if (!copies_.empty())
            count = copy_columns_.template findNear<false>(cluster, 0, reach, columns_.slots(),
                                                           chunk.j, count);
        fillUp(s);
        range.two_sided = count / tile_side;
        count = columns_.template findNear<true>(cluster, s + tile_side, reach, 0, chunk.j, count);
        for (Index m = range.two_sided * tile_side; m < count; ++m)
            farthest = std::max(farthest, chunk.j[m] + 1);
        fillUp(s);
        chunk.ranges.push_back(range);
    }
    chunk.ranges.push_back({count / tile_side, count / tile_side});
    chunk.reach_end = farthest;
}

/// Weights of all pairs, and the sums of W.
template <int Dim>
template <class K, class Real>
void PairTiles<Dim>::weigh(Chunk& chunk, const kernels::Kernel<Dim>& kernel,
                           ExactNumber* all_sums) const {
    constexpr double reach2 = places_of_cutoff * places_of_cutoff;
    constexpr double q_per_place = K::reach / places_of_cutoff;
    const double h = kernel.smoothingLength();
    const double factor =
        -kernel.gradientFactor() * kernelUnit(kernel) / (h * h) * place_unit_ / gradient_unit_;
    ExactNumber* sums = sumsOf(chunk, 1, all_sums);
    std::fill(sums + chunk.first_slot, sums + chunk.reach_end, ExactNumber{});
    AlignedVector<Real>& weights = chunk.template weights<Real>();
    makeRoom(weights, chunk.ranges.back().one_sided * std::size_t{tile_size});
    const auto* words = reinterpret_cast<const float*>(places_.data());
    constexpr WholeTile lane_i = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    constexpr WholeTile lane_j = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    constexpr std::int32_t beyond = std::numeric_limits<std::int32_t>::max();

    const std::uint32_t* j = chunk.j.data();
    Real* weight = weights.data();
    for (std::size_t c = 0; c + 1 < chunk.ranges.size(); ++c) {
        const Index first = chunk.first_slot + static_cast<Index>(c) * tile_side;
        const std::uint32_t own[tile_side] = {first, first + 1, first + 2, first + 3};
        FloatTile of_i[Place::size];
        gatherOfEach<Of::i, Place::words>(words, own, of_i);
        int filled = tile_side;  // empty slots are the last ones of a cluster
        while (columns_.point(first + static_cast<Index>(filled) - 1) == none) --filled;
        const WholeTile is_i = lane_i < filled;

        ExactTile sum[1] = {};
        const Range& range = chunk.ranges[c];
        const std::uint32_t end = chunk.ranges[c + 1].one_sided;
        for (std::uint32_t t = range.one_sided; t < end; ++t, j += tile_side, weight += tile_size) {
            WholeTile is_pair = is_i;
            if (t == range.one_sided) {
                is_pair &= (lane_j < filled) & (lane_i != lane_j);
            } else if (t + 1 == range.two_sided || t + 1 == end) {
                // Places of a last tile that repeat a slot of the cluster.
                int pairs = tile_side;
                while (pairs > 0 && j[pairs - 1] - first < tile_side) --pairs;
                is_pair &= lane_j < pairs;
            }
            FloatTile of_j[Place::size];
            gatherOfEach<Of::j, Place::words>(words, j, of_j);
            DoubleTile exact[Dim];
            FloatTile near2 = tile(1e-6f), rest2 = {};
            for (int k = 0; k < Dim; ++k) {
                WholeTile d = wrappedDifference(reinterpret_cast<WholeTile>(of_j[k]),
                                                reinterpret_cast<WholeTile>(of_i[k]));
                if (k == 0) d = is_pair ? d : beyond + WholeTile{};
                exact[k] = {lowLanes(d), highLanes(d)};
                const FloatTile rounded = toFloat(d);
                near2 += rounded * rounded;
                rest2 += rounded * (of_j[Dim + k] - of_i[Dim + k]);
            }
            const DoubleTile r2 =
                dot<Dim>(exact, exact) + 2.0 * DoubleTile{lowLanes(rest2), highLanes(rest2)};
            // Twice the digits of a float: enough for sums, and weights that become floats.
            const FloatTile per_r = inverseSqrtTile(near2);
            DoubleTile w, g;
            const auto evaluate = [&](Lanes r2, Lanes x, Lanes & w, Lanes & g)
                __attribute__((always_inline)) {
                x *= 1.5 - 0.5 * r2 * x * x;
                if (std::is_same_v<Real, double>) x *= 1.5 - 0.5 * r2 * x * x;
                const Lanes q = q_per_place * (r2 * x);
                const Lanes per_q = (1 / q_per_place) * x;
                const LaneMask inside = r2 < reach2;
                w = inside ? kernel_scale * K::w(q) : Lanes{};
                g = inside ? factor * K::dwOverQ(q, per_q) : Lanes{};
            };
            evaluate(r2.low, lowLanes(per_r), w.low, g.low);
            evaluate(r2.high, highLanes(per_r), w.high, g.high);
            if constexpr (std::is_same_v<Real, float>)
                storeTile(joinFloats(g.low, g.high), weight);
            else
                storeTile(g, weight);
            const ExactTile term[1] = {ExactTile(w)};
            sum[0] += term[0];
            if (t >= range.two_sided) addOverI<1, 1>(term, j, sums);
        }
        addOverJ<1>(sum, sums + first);
    }
}

template <int Dim>
void PairTiles<Dim>::gather(const Chunk& chunk, std::size_t stride, ExactNumber* sums) const {
    ExactNumber* own = sumsOf(chunk, stride, sums);
    for (const Chunk& other : chunks_) {
        if (other.first_slot >= chunk.first_slot) break;
        const ExactNumber* given = sumsOf(other, stride, sums);
        const std::size_t end = stride * std::min(other.reach_end, chunk.end_slot);
        for (std::size_t m = stride * chunk.first_slot; m < end; ++m) own[m] += given[m];
    }
}

template <int Dim>
std::size_t PairTiles<Dim>::bytes() const {
    std::size_t sum = columns_.bytes() + copy_columns_.bytes() +
                      sizeof(Place) * (places_.capacity() + copy_places_.capacity()) +
                      sizeof(Index) * (copies_.capacity() + originals_.capacity() +
                                       slot_of_.capacity() + sum_places_.capacity()) +
                      sizeof(Vec<Dim>) * copy_positions_.capacity() +
                      sizeof(ExactNumber) * sums_.capacity() + 8 * kernel_sum_.capacity();
    for (const Chunk& chunk : chunks_)
        sum += sizeof(Range) * chunk.ranges.capacity() + 4 * chunk.j.capacity() +
               4 * chunk.template weights<float>().capacity() +
               8 * chunk.template weights<double>().capacity();
    return sum;
}

template class PairTiles<2>;
template class PairTiles<3>;

}  // namespace sphinx::neighbors
