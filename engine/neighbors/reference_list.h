// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sphinx::neighbors {

/// Neighbors in the reference configuration, of eight particles at a time that stand one after the
/// other (a group): a block holds one neighbor of each. On a lattice the neighbors of eight
/// particles in a row stand in a row themselves: such a block, a run, is read without gathering. Of
/// the blocks of a group the runs come first. On a lattice there are also few different blocks but
/// for the indices, each of which is there once and stays in the caches.
template <int Dim>
class ReferenceList {
 public:
    /// A neighbor of a particle of the group.
    struct Neighbor {
        int lane;           ///< place of the particle in its group
        Index index;        ///< j
        Vec<Dim> gradient;  ///< e_ij W'_ij V_j, 1/length; not 0
        /// abs(W'_ij)/R_ij V_j times the mean share of both (ElasticRole::shares). 1/length^2
        double weight;
    };
    using Lane = std::array<double, lane_count>;
    /// Of the pairs of a block, 0 where a particle has no neighbor in it.
    struct Terms {
        std::array<Lane, Dim> gradient;  ///< component by component
        Lane weight;

        bool operator==(const Terms&) const = default;
    };
    struct GroupBlocks {
        std::uint64_t first_block = 0;
        std::uint64_t first_index = 0;
        std::uint32_t runs = 0;
        std::uint32_t blocks = 0;  ///< runs included
    };

    /// The next group: all its neighbors, of a body of so many particles. Sorts them.
    void append(std::vector<Neighbor>& neighbors, std::size_t particles);
    /// After the last one: gives back what the list itself does not need.
    void finish();

    const GroupBlocks& group(std::size_t number) const { return groups_[number]; }
    /// Of block b of the group.
    const Terms& terms(const GroupBlocks& group, std::uint32_t b) const {
        return terms_[blocks_[group.first_block + b]];
    }
    /// Of a run the neighbor of the first particle, of every other block the neighbors of all.
    const Index* indices(const GroupBlocks& group) const {
        return indices_.data() + group.first_index;
    }

    /// f(j, weight) for all neighbors of particle i.
    template <class Function>
    void forEach(std::size_t i, Function&& f) const {
        const GroupBlocks& group = groups_[i / lane_count];
        const std::size_t lane = i % lane_count;
        const Index* index = indices(group);
        for (std::uint32_t b = 0; b < group.blocks; ++b) {
            const bool run = b < group.runs;
            const Index j = run ? static_cast<Index>(index[0] + lane) : index[lane];
            index += run ? 1 : lane_count;
            const Terms& of_block = terms(group, b);
            bool unused = true;
            for (const Lane& component : of_block.gradient) unused &= component[lane] == 0;
            if (!unused) f(j, of_block.weight[lane]);
        }
    }
    std::size_t bytes() const;

 private:
    struct Hash {
        std::size_t operator()(const Terms& terms) const;
    };

    void appendBlock(const Terms& terms);
    static void put(const Neighbor& neighbor, Terms& terms);

    AlignedVector<GroupBlocks> groups_;
    AlignedVector<Terms> terms_;   // that differ
    AlignedVector<Index> blocks_;  // which of them each block has
    AlignedVector<Index> indices_;
    std::unordered_map<Terms, Index, Hash> known_;  // where they are, until the list is finished
};

extern template class ReferenceList<2>;
extern template class ReferenceList<3>;

}  // namespace sphinx::neighbors
