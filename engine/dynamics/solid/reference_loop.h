// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/group.h"
#include "dynamics/words.h"

#include <array>

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

/// What a list says of eight pairs; 0 where a particle has no neighbor.
template <int Dim>
struct PairsOfBlock {
    const typename ReferenceList<Dim>::Terms& terms;

    /// e_ij W'_ij V_j, 1/length.
    VecOf<Dim, Wide> gradient() const {
        VecOf<Dim, Wide> g;
        for (int c = 0; c < Dim; ++c)
            g[c] = loadLanes(terms.gradient[static_cast<std::size_t>(c)].data());
        return g;
    }
    Wide weight() const { return loadLanes(terms.weight.data()); }
};

/// term(neighbors, pairs) for all blocks of a group: Run or Scattered, and PairsOfBlock.
template <int Dim, class Term>
[[gnu::always_inline]] inline void forEachBlock(const ReferenceList<Dim>& list, const Group& group,
                                                Term&& term) {
    const auto& blocks = list.group(group.number());
    const Index* index = list.indices(blocks);
    std::uint32_t b = 0;
    for (; b < blocks.runs; ++b, ++index)
        term(Run{index}, PairsOfBlock<Dim>{list.terms(blocks, b)});
    for (; b < blocks.blocks; ++b, index += lane_count)
        term(Scattered{index}, PairsOfBlock<Dim>{list.terms(blocks, b)});
}

/// sum_j (a_j - a_i) (x) g_ij over the neighbors, a the values in their body.
template <int Dim>
inline MatOf<Dim, Wide> differenceSum(const ReferenceList<Dim>& list, const Group& group,
                                      const VecOf<Dim, Wide>& own, const Field<Vec<Dim>>& values) {
    MatOf<Dim, Wide> sum = MatOf<Dim, Wide>::Zero();
    forEachBlock<Dim>(list, group, [&](const auto& neighbors, const PairsOfBlock<Dim>& pairs) {
        const VecOf<Dim, Wide> difference = load(values, neighbors) - own;
        sum += difference * pairs.gradient().transpose();
    });
    return sum;
}

/// sum_j (T_i + T_j) g_ij over the neighbors, and where `control` is not 0
/// control sum_j k_ij (r_j - r_i), k the weights of the list. (Differences, so that rounding does
/// not grow with the distance from the origin; sums of two, so that what i gets j loses.)
/// stress(neighbors): T_j of eight of them.
template <int Dim, class Stress>
inline VecOf<Dim, Wide> forceSum(const ReferenceList<Dim>& list, const Group& group,
                                 const MatOf<Dim, Wide>& own_stress, Stress&& stress,
                                 double control, const VecOf<Dim, Wide>& own_place,
                                 const Field<Vec<Dim>>& places) {
    VecOf<Dim, Wide> force = VecOf<Dim, Wide>::Zero();
    VecOf<Dim, Wide> pull = VecOf<Dim, Wide>::Zero();
    const auto add = [&](const auto& neighbors, const PairsOfBlock<Dim>& pairs) {
        const MatOf<Dim, Wide> T = stress(neighbors) + own_stress;
        const VecOf<Dim, Wide> g = pairs.gradient();
        for (int c = 0; c < Dim; ++c) force += g[c] * T.col(c);
    };
    if (control == 0) {
        forEachBlock<Dim>(list, group, add);
        return force;
    }
    forEachBlock<Dim>(list, group, [&](const auto& neighbors, const PairsOfBlock<Dim>& pairs) {
        add(neighbors, pairs);
        pull += pairs.weight() * (load(places, neighbors) - own_place);
    });
    return force + control * pull;
}

/// The values of a matrix field component by component: a run of neighbors is read without a
/// shuffle.
template <int Dim>
class Planes {
 public:
    void resize(std::size_t particles) {
        for (auto& plane : planes_) plane.resize(groupCount(particles) * lane_count);
    }
    void store(const MatOf<Dim, Wide>& value, const Group& group) {
        for (std::size_t c = 0; c < planes_.size(); ++c)
            storeLanes(value.data()[c].at, planes_[c].data() + group.first);
    }
    /// Whether these are the values of the group, to the last bit.
    bool holds(const MatOf<Dim, Wide>& value, const Group& group) const {
        LaneMask differs{};
        for (std::size_t c = 0; c < planes_.size(); ++c)
            differs |= reinterpret_cast<LaneMask>(value.data()[c].at) ^
                       reinterpret_cast<LaneMask>(loadLanes(planes_[c].data() + group.first));
        return maskBits(differs != 0) == 0;
    }
    void set(std::size_t i, const Mat<Dim>& value) {
        for (std::size_t c = 0; c < planes_.size(); ++c) planes_[c][i] = value.data()[c];
    }
    MatOf<Dim, Wide> load(const Run& run) const {
        MatOf<Dim, Wide> value;
        for (std::size_t c = 0; c < planes_.size(); ++c)
            value.data()[c] = loadLanes(planes_[c].data() + *run.first);
        return value;
    }

 private:
    std::array<AlignedVector<double>, Dim * Dim> planes_;
};

}  // namespace sphinx::dynamics::solid
