// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/pair_loop.h"
#include "neighbors/relations.h"

#include <cstring>

// Sums over neighbors in the reference configuration, eight at a time.
// gradient = e_ij W'_ij V_j, 1/length; unused places have a zero gradient.
namespace sphinx::solid {

/// Adds sum_j a_j (x) g_j over the neighbors of i to `sum`, a of eight particles at a time.
template <int Dim>
inline void addOuter(const NeighborList<Dim, double>& list, std::size_t i, const Vec<Dim>* values,
                     Lanes sum[Dim][Dim]) {
    for (const auto& block : list.of(i)) {
        Lanes a[Dim];
        gatherVectors<Dim>(values, block.index, a);
        for (int d = 0; d < Dim; ++d) {
            const Lanes g = loadLanes(block.gradient[d]);
            for (int c = 0; c < Dim; ++c) sum[c][d] += a[c] * g;
        }
    }
}

/// The sums over the lanes of a matrix of them.
template <int Dim>
inline Mat<Dim> sumMatrix(const Lanes (&sum)[Dim][Dim]) {
    Mat<Dim> result;
    if constexpr (Dim == 2) {
        const HalfLanes columns = sumLanes(sum[0][0], sum[1][0], sum[0][1], sum[1][1]);
        std::memcpy(result.data(), &columns, sizeof columns);
    } else {
        for (int c = 0; c < Dim; ++c)
            for (int d = 0; d < Dim; ++d) result(c, d) = sumLanes(sum[c][d]);
    }
    return result;
}

/// Adds factor sum_j k_j (a_j - own) over the neighbors of i to `sum`, k the weights of their
/// places. (Differences, so that rounding does not grow with the distance from the origin.)
template <int Dim>
inline void addWeighted(const NeighborList<Dim, double>& list, const double* weights, double factor,
                        std::size_t i, const Vec<Dim>& own, const Vec<Dim>* values,
                        Lanes sum[Dim]) {
    const double* weight = weights + list.ranges[i].first * lane_count;
    for (const auto& block : list.of(i)) {
        Lanes a[Dim];
        gatherVectors<Dim>(values, block.index, a);
        const Lanes k = factor * loadLanes(weight);
        for (int c = 0; c < Dim; ++c) sum[c] += k * (a[c] - own[c]);
        weight += lane_count;
    }
}

/// Adds sum_j T_j g_j over the neighbors of i to `sum`.
template <int Dim>
inline void addProduct(const NeighborList<Dim, double>& list, std::size_t i, const Mat<Dim>* values,
                       Lanes sum[Dim]) {
    const double* flat = values->data();
    for (const auto& block : list.of(i)) {
        if constexpr (Dim == 2) {
            Lanes t[4];
            gatherRecords<4>(flat, block.index, t);
            const Lanes g0 = loadLanes(block.gradient[0]);
            const Lanes g1 = loadLanes(block.gradient[1]);
            sum[0] += t[0] * g0 + t[2] * g1;
            sum[1] += t[1] * g0 + t[3] * g1;
        } else {
            for (int d = 0; d < Dim; ++d) {
                const Lanes g = loadLanes(block.gradient[d]);
                for (int c = 0; c < Dim; ++c) {
                    const double* column = flat + Dim * d + c;
                    const auto at = [&](int k) {
                        return column[static_cast<std::size_t>(Dim * Dim) * block.index[k]];
                    };
                    sum[c] += g * Lanes{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
                }
            }
        }
    }
}

}  // namespace sphinx::solid
