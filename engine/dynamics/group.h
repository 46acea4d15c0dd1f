// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/parallel.h"
#include "core/records.h"
#include "core/wide.h"
#include "dynamics/words.h"

#include <algorithm>

// Loops over eight particles at a time.
namespace sphinx::dynamics {

/// Eight particles that stand one after the other, or what is left of them at the end of a body.
struct Group {
    std::size_t first;
    std::size_t count;

    std::size_t number() const { return first / lane_count; }
};

/// Groups of n particles.
inline std::size_t groupCount(std::size_t n) { return (n + lane_count - 1) / lane_count; }
inline Group groupOf(std::size_t number, std::size_t n) {
    const std::size_t first = number * lane_count;
    return {first, std::min<std::size_t>(lane_count, n - first)};
}

/// Groups that a reduction takes in one block.
inline constexpr std::size_t group_block = 1024 / lane_count;

/// body(Group) for all groups of n particles. All that it calls and that is known here is inlined:
/// a matrix of Wide is as large as the registers, and each call would write it to memory and read
/// it back, one in the midst of a loop over neighbors as often as there are neighbors.
template <class Body>
void parallelForGroups(std::size_t n, Body&& body) {
    parallelFor(
        groupCount(n),
        [&](std::size_t number) __attribute__((flatten)) { body(groupOf(number, n)); },
        default_grain / lane_count);
}

namespace detail {

/// Records of a group. Lanes beyond the end of the body repeat its last particle.
template <int Size>
[[gnu::always_inline]] inline void load(const double* values, const Group& group, Lanes a[Size]) {
    const double* p = values + Size * group.first;
    if (group.count == lane_count) [[likely]]
        return loadRecords<Size>(p, a);
    double whole[Size * lane_count];
    for (std::size_t k = 0; k < lane_count; ++k)
        std::copy_n(p + Size * std::min(k, group.count - 1), Size, whole + Size * k);
    loadRecords<Size>(whole, a);
}
template <int Size>
[[gnu::always_inline]] inline void store(const Lanes a[Size], double* values, const Group& group) {
    double* p = values + Size * group.first;
    if (group.count == lane_count) [[likely]]
        return storeRecords<Size>(a, p);
    double whole[Size * lane_count];
    storeRecords<Size>(a, whole);
    std::copy_n(whole, Size * group.count, p);
}

}  // namespace detail

/// A vector or a matrix by its components, column by column.
template <int Rows, int Columns>
inline Eigen::Matrix<Wide, Rows, Columns> wide(const Lanes* a) {
    Eigen::Matrix<Wide, Rows, Columns> value;
    std::copy_n(a, Rows * Columns, value.data());
    return value;
}
/// That of particle k of the group.
template <int Rows, int Columns>
inline Eigen::Matrix<double, Rows, Columns> lane(const Eigen::Matrix<Wide, Rows, Columns>& value,
                                                 std::size_t k) {
    return value.unaryExpr([&](const Wide& a) { return a[k]; });
}

// Values of a group: those of a scalar field are Wide, of others VecOf<Dim, Wide> or MatOf<Dim,
// Wide>.

inline Wide load(const double* values, const Group& group) {
    Lanes a;
    detail::load<1>(values, group, &a);
    return a;
}
inline Wide load(const Field<double>& field, const Group& group) {
    return load(field.data(), group);
}
inline void store(const Wide& value, Field<double>& field, const Group& group) {
    detail::store<1>(&value.at, field.data(), group);
}
template <int Rows, int Columns>
[[gnu::always_inline]] inline auto load(const Eigen::Matrix<double, Rows, Columns>* values,
                                        const Group& group) {
    constexpr int size = Rows * Columns;
    Lanes a[size];
    detail::load<size>(values->data(), group, a);
    return wide<Rows, Columns>(a);
}
template <int Rows, int Columns>
[[gnu::always_inline]] inline auto load(const Field<Eigen::Matrix<double, Rows, Columns>>& field,
                                        const Group& group) {
    return load(field.data(), group);
}
template <int Rows, int Columns>
[[gnu::always_inline]] inline void store(const Eigen::Matrix<Wide, Rows, Columns>& value,
                                         Eigen::Matrix<double, Rows, Columns>* values,
                                         const Group& group) {
    constexpr int size = Rows * Columns;
    Lanes a[size];
    for (int c = 0; c < size; ++c) a[c] = value.data()[c].at;
    detail::store<size>(a, values->data(), group);
}
template <int Rows, int Columns>
[[gnu::always_inline]] inline void store(const Eigen::Matrix<Wide, Rows, Columns>& value,
                                         Field<Eigen::Matrix<double, Rows, Columns>>& field,
                                         const Group& group) {
    store(value, field.data(), group);
}

// What is done to every number alike needs no transposed records.

/// sum += factor a
template <int Rows, int Columns>
[[gnu::always_inline]] inline void addProduct(double factor,
                                              const Field<Eigen::Matrix<double, Rows, Columns>>& a,
                                              Field<Eigen::Matrix<double, Rows, Columns>>& sum,
                                              const Group& group) {
    constexpr std::size_t size = Rows * Columns;
    const double* p = a.data()->data() + size * group.first;
    double* s = sum.data()->data() + size * group.first;
    if (group.count == lane_count) [[likely]] {
        for (std::size_t k = 0; k < size * lane_count; k += lane_count)
            storeLanes(loadLanes(s + k) + factor * loadLanes(p + k), s + k);
        return;
    }
    for (std::size_t k = 0; k < size * group.count; ++k) s[k] += factor * p[k];
}

/// Whether all values of the group are 0.
template <int Rows, int Columns>
[[gnu::always_inline]] inline bool isZero(const Field<Eigen::Matrix<double, Rows, Columns>>& field,
                                          const Group& group) {
    constexpr std::size_t size = Rows * Columns;
    const double* p = field.data()->data() + size * group.first;
    if (group.count == lane_count) [[likely]] {
        LaneMask differs{};
        for (std::size_t k = 0; k < size * lane_count; k += lane_count)
            differs |= loadLanes(p + k) != 0;
        return maskBits(differs) == 0;
    }
    return std::all_of(p, p + size * group.count, [](double value) { return value == 0; });
}
template <int Rows, int Columns>
inline void setZero(Field<Eigen::Matrix<double, Rows, Columns>>& field, const Group& group) {
    constexpr std::size_t size = Rows * Columns;
    std::fill_n(field.data()->data() + size * group.first, size * group.count, 0.0);
}

}  // namespace sphinx::dynamics
