// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "core/parallel.h"
#include "core/precision.h"
#include "neighbors/columns.h"

#include <array>
#include <tuple>
#include <vector>

namespace sphinx::neighbors {

/// The pairs of a body's own particles that are nearer than the cutoff, each of them once, for sums
/// that give something to both. Four particles i that stand near each other (a cluster) share one
/// list of particles j; a tile (core/tile.h) is the pairs of a cluster with four of its list. Each
/// pair carries a weight, abs(W')/r: it is 0 where a tile has a pair that is none.
///
/// Particles stand in slots, in the order of Columns, and after them copies: the images of
/// particles across periodic sides. Places are whole numbers of a unit, modulo 2^32 of it: so the
/// difference of two is exact, and exactly that of the pair seen from the other side.
///
/// Of each cluster the tiles come first that give nothing to j: the pairs within the cluster, each
/// seen from both sides, and those with copies.
template <int Dim>
class PairTiles {
 public:
    static constexpr Index none = Columns<Dim>::none;
    /// Where a particle stands: a whole number of units, and what rounding has left of it.
    struct alignas(Dim == 2 ? 16 : 32) Place {
        std::int32_t whole[Dim] = {};
        float rest[Dim] = {};
        static constexpr int words = 2 * Dim;
        static constexpr int size = Dim == 2 ? 4 : 8;
    };

    struct Range {
        std::uint32_t one_sided;  ///< first tile of the cluster
        std::uint32_t two_sided;  ///< first tile that gives to both sides
    };
    /// Clusters that one thread works on, with their tiles, and where their sums stand: those of
    /// the slots that they give to.
    struct Chunk {
        Index first_slot = 0, end_slot = 0;
        Index reach_end = 0;             ///< of the slots
        std::size_t sums_at = 0;         ///< place of the sums of the first slot
        std::vector<Range> ranges;       ///< of the clusters, and one more
        AlignedVector<std::uint32_t> j;  ///< slots, four for each tile
        /// Sixteen for each tile, in the precision of the tiles.
        template <class Real>
        AlignedVector<Real>& weights() {
            return std::get<AlignedVector<Real>>(weights_);
        }
        template <class Real>
        const AlignedVector<Real>& weights() const {
            return std::get<AlignedVector<Real>>(weights_);
        }

     private:
        std::tuple<AlignedVector<float>, AlignedVector<double>> weights_;
    };

    explicit PairTiles(Precision precision = Precision::single) : precision_(precision) {}

    /// Of particles at these positions. Throws PhysicsError when one of them is not finite.
    void build(const Vec<Dim>* position, std::size_t n, const kernels::Kernel<Dim>& kernel,
               double spacing, const bodies::Domain<Dim>& domain);

    /// Of the terms of pairs.
    Precision precision() const { return precision_; }
    /// Counts the builds: whoever keeps something for each slot compares it.
    std::uint64_t builds() const { return builds_; }
    /// All of them, copies included.
    Index slots() const { return static_cast<Index>(places_.size()); }
    /// The particle in a slot or none.
    Index particle(Index slot) const {
        if (slot < columns_.slots()) return columns_.point(slot);
        const Index copy = copy_columns_.point(slot - columns_.slots());
        return copy == none ? none : copies_[copy];
    }
    /// The same for the slots of own particles, one after the other.
    const Index* particles() const { return columns_.points(); }
    /// Copies are in the slots from here on.
    Index firstCopy() const { return columns_.slots(); }
    /// The slots of the particles, one after the other, and at the end the last one again, for
    /// whoever reads eight at a time.
    const Index* slotsOf() const { return slot_of_.data(); }
    /// The slot of the particle of which there is a copy in this one; none where it is empty.
    Index original(Index slot) const { return originals_[slot - firstCopy()]; }
    const Place& place(Index slot) const { return places_[slot]; }
    const std::vector<Chunk>& chunks() const { return chunks_; }
    /// Length of a step from one place to the next.
    double placeUnit() const { return place_unit_; }
    /// Weight times a difference of places is e W' in this unit, 1/length^(Dim+1). Of the products
    /// with what is of the size of 1, sums of a particle stay below 2^51.
    double gradientUnit() const { return gradient_unit_; }
    /// Of each particle the sum over its neighbors of W, 1/length^Dim.
    const double* kernelSums() const { return kernel_sum_.data(); }

    /// How many numbers all chunks need for sums, of each kind.
    std::size_t sumCount() const { return sum_count_; }
    /// Adds to the sums of a chunk's own slots what other chunks have for them. `stride`: numbers
    /// of each slot.
    void gather(const Chunk& chunk, std::size_t stride, ExactNumber* sums) const;
    /// sums + stride * slot are the sums of a slot that the chunk reaches.
    static ExactNumber* sumsOf(const Chunk& chunk, std::size_t stride, ExactNumber* sums) {
        return sums + stride * (chunk.sums_at - chunk.first_slot);
    }
    /// After gather(), sums + stride * sumPlaces()[i] are those of particle i. As slotsOf().
    const Index* sumPlaces() const {
        return chunks_.size() > 1 ? sum_places_.data() : slot_of_.data();
    }
    /// f(first slot of the cluster, slots of the j, how many, pairs) for all clusters; there are
    /// four j for each tile; bit k of pairs(tile) is set where its lane k has a pair.
    template <class Function>
    void forEachCluster(Function&& f) const {
        withPrecision(precision_, [&]<class Real>() {
            parallelFor(
                chunks_.size(),
                [&](std::size_t n) {
                    const Chunk& chunk = chunks_[n];
                    for (std::size_t c = 0; c + 1 < chunk.ranges.size(); ++c) {
                        const std::size_t begin = chunk.ranges[c].one_sided;
                        const Real* weights =
                            chunk.template weights<Real>().data() + tile_size * begin;
                        f(chunk.first_slot + static_cast<Index>(tile_side * c),
                          chunk.j.data() + tile_side * begin,
                          tile_side * (chunk.ranges[c + 1].one_sided - begin),
                          [&](std::size_t tile) {
                              return lessBits(TileOf<Real>{}, loadTile(weights + tile_size * tile));
                          });
                    }
                },
                1);
        });
    }
    std::size_t bytes() const;

 private:
    template <class K, class Real>
    void weigh(Chunk& chunk, const kernels::Kernel<Dim>& kernel, ExactNumber* sums) const;
    void findTiles(Chunk& chunk, float reach) const;
    void makeCopies(const Vec<Dim>* position, std::size_t n, const Box<Dim>& bounds,
                    const bodies::Domain<Dim>& domain, double spacing, double cutoff);
    void divide();

    Precision precision_;
    std::uint64_t builds_ = 0;
    double place_unit_ = 1;
    double gradient_unit_ = 1;
    Columns<Dim> columns_;
    Columns<Dim> copy_columns_;
    AlignedVector<Index> slot_of_;
    AlignedVector<Index> sum_places_;  // where there are several chunks
    AlignedVector<Index> copies_;      // their particles
    AlignedVector<Index> originals_;   // of the slots of copies, the slots of their particles
    AlignedVector<Place> copy_places_;
    AlignedVector<Vec<Dim>> copy_positions_;
    AlignedVector<Place> places_;
    std::vector<Chunk> chunks_;
    std::size_t sum_count_ = 0;
    AlignedVector<ExactNumber> sums_;
    AlignedVector<double> kernel_sum_;
};

extern template class PairTiles<2>;
extern template class PairTiles<3>;

}  // namespace sphinx::neighbors
