// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"
#include "dynamics/words.h"

// Sums over neighbors in the reference configuration, of the eight particles of a group at a time.
namespace sphinx::dynamics::solid {

/// One neighbor of each particle: eight that stand one after the other.
struct Run {
    const Index* first;

    template <int Size>
    void load(const double* values, Lanes a[Size]) const {
        loadRecords<Size>(values + Size * std::size_t{*first}, a);
    }
};
/// One neighbor of each particle, anywhere.
struct Scattered {
    const Index* index;

    template <int Size>
    void load(const double* values, Lanes a[Size]) const {
        if constexpr (Size == 2)
            gatherPairs(values, index, a);
        else if constexpr (Size == 4)
            gatherRecords<4>(values, index, a);
        else
            for (int c = 0; c < Size; ++c) {
                const auto at = [&](int k) { return values[Size * std::size_t{index[k]} + c]; };
                a[c] = Lanes{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
            }
    }
};
/// Of those neighbors.
template <int Rows, int Columns, class Places>
inline auto load(const Field<Eigen::Matrix<double, Rows, Columns>>& field, const Places& places) {
    Lanes a[Rows * Columns];
    places.template load<Rows * Columns>(field.data()->data(), a);
    return wide<Rows, Columns>(a);
}

/// term(b, neighbors, g) for all blocks of a group: number of the block, Run or Scattered, and
/// g = e_ij W'_ij V_j of the eight pairs, 1/length. Where a particle has no neighbor, g is 0.
template <int Dim, class Term>
inline void forEachBlock(const ReferenceList<Dim>& list, const Group& group, Term&& term) {
    const auto& blocks = list.group(group.number());
    const auto* gradients = list.gradients(blocks);
    const Index* index = list.indices(blocks);
    const auto gradient = [&](std::uint32_t b) {
        VecOf<Dim, Wide> g;
        for (int c = 0; c < Dim; ++c)
            g[c] = loadLanes(gradients[b][static_cast<std::size_t>(c)].data());
        return g;
    };
    std::uint32_t b = 0;
    for (; b < blocks.runs; ++b, ++index) term(b, Run{index}, gradient(b));
    for (; b < blocks.blocks; ++b, index += lane_count) term(b, Scattered{index}, gradient(b));
}

/// sum_j (a_j - a_i) (x) g_ij over the neighbors, a the values in their body.
template <int Dim>
inline MatOf<Dim, Wide> differenceSum(const ReferenceList<Dim>& list, const Group& group,
                                      const VecOf<Dim, Wide>& own, const Field<Vec<Dim>>& values) {
    MatOf<Dim, Wide> sum = MatOf<Dim, Wide>::Zero();
    forEachBlock<Dim>(list, group, [&](auto, const auto& neighbors, const VecOf<Dim, Wide>& g) {
        const VecOf<Dim, Wide> difference = load(values, neighbors) - own;
        sum += difference * g.transpose();
    });
    return sum;
}

/// sum_j k_ij (a_j - a_i) over the neighbors, k the weights of the list. (Differences, so that
/// rounding does not grow with the distance from the origin.)
template <int Dim>
inline VecOf<Dim, Wide> weightedSum(const ReferenceList<Dim>& list, const Group& group,
                                    const VecOf<Dim, Wide>& own, const Field<Vec<Dim>>& values) {
    VecOf<Dim, Wide> sum = VecOf<Dim, Wide>::Zero();
    const auto* weights = list.weights(list.group(group.number()));
    forEachBlock<Dim>(list, group, [&](auto b, const auto& neighbors, const VecOf<Dim, Wide>&) {
        sum += Wide(loadLanes(weights[b].data())) * (load(values, neighbors) - own);
    });
    return sum;
}

/// sum_j (T_i + T_j) g_ij over the neighbors.
template <int Dim>
inline VecOf<Dim, Wide> productSum(const ReferenceList<Dim>& list, const Group& group,
                                   const MatOf<Dim, Wide>& own, const Field<Mat<Dim>>& values) {
    VecOf<Dim, Wide> sum = VecOf<Dim, Wide>::Zero();
    forEachBlock<Dim>(list, group, [&](auto, const auto& neighbors, const VecOf<Dim, Wide>& g) {
        sum += (load(values, neighbors) + own) * g;
    });
    return sum;
}

}  // namespace sphinx::dynamics::solid
