// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/group.h"
#include "particles/fields.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <numeric>
#include <vector>

using namespace sphinx;
using namespace sphinx::dynamics;

TEST_CASE("groups cover each particle once, and the last is as long as what is left") {
    for (std::size_t n : {0, 1, 7, 8, 9, 16, 1000}) {
        std::vector<std::atomic<int>> visits(n);
        parallelForGroups(n, [&](const Group& group) {
            CHECK(group.first == lane_count * group.number());
            for (std::size_t k = 0; k < group.count; ++k) ++visits[group.first + k];
        });
        for (const auto& visited : visits) CHECK(visited == 1);
    }
}

namespace {

template <class T>
Field<T> countingField(std::size_t n) {
    Field<T> field(fields::velocity);
    field.resize(n);
    const std::size_t count = n * field.components();
    std::iota(field.numbers(), field.numbers() + count, 1.0);
    return field;
}

/// What is stored to a group reaches its particles and no other; lanes beyond the end of the body
/// repeat its last particle.
template <class T>
void checkLoadAndStore() {
    const std::size_t n = 2 * lane_count + 3;
    const Field<T> from = countingField<T>(n);
    Field<T> to = countingField<T>(n);
    const int size = from.components();
    const double* source = from.data()->data();
    for (std::size_t number = 0; number < groupCount(n); ++number) {
        const Group group = groupOf(number, n);
        const auto value = load(from, group);
        for (std::size_t k = 0; k < lane_count; ++k) {
            const std::size_t particle = std::min(group.first + k, n - 1);
            for (int c = 0; c < size; ++c) CHECK(value.data()[c][k] == source[size * particle + c]);
            CHECK(lane(value, k) == from[particle]);
        }
        const auto doubled = value + value;
        store(decltype(load(from, group))(doubled), to, group);
    }
    for (std::size_t i = 0; i < n; ++i) CHECK(to[i] == T(2 * from[i]));
}

}  // namespace

TEST_CASE("vectors and matrices of a group are those of its particles") {
    checkLoadAndStore<Vec<2>>();
    checkLoadAndStore<Vec<3>>();
    checkLoadAndStore<Mat<2>>();
    checkLoadAndStore<Mat<3>>();
}

TEST_CASE("numbers of a group are those of its particles") {
    for (std::size_t n : {1, 8, 13}) {
        const Field<double> from = countingField<double>(n);
        Field<double> to = countingField<double>(n);
        for (std::size_t number = 0; number < groupCount(n); ++number) {
            const Group group = groupOf(number, n);
            const Wide value = load(from, group);
            for (std::size_t k = 0; k < lane_count; ++k)
                CHECK(value[k] == from[std::min(group.first + k, n - 1)]);
            store(value * 3.0, to, group);
        }
        for (std::size_t i = 0; i < n; ++i) CHECK(to[i] == 3 * from[i]);
    }
}

TEST_CASE("what is done to all numbers of a group reaches its particles alone") {
    const std::size_t n = 2 * lane_count + 3;
    for (std::size_t number = 0; number < groupCount(n); ++number) {
        const Group group = groupOf(number, n);
        const auto isIn = [&](std::size_t i) {
            return i >= group.first && i < group.first + group.count;
        };
        const Field<Mat<2>> a = countingField<Mat<2>>(n);
        Field<Mat<2>> sum = countingField<Mat<2>>(n);
        addProduct(0.5, a, sum, group);
        for (std::size_t i = 0; i < n; ++i) CHECK(sum[i] == (isIn(i) ? Mat<2>(1.5 * a[i]) : a[i]));

        Field<Mat<2>> zero = countingField<Mat<2>>(n);
        setZero(zero, group);
        CHECK(isZero(zero, group));
        for (std::size_t i = 0; i < n; ++i) CHECK(zero[i].isZero(0) == isIn(i));
        for (std::size_t k = 0; k < group.count; ++k) {
            zero[group.first + k](0, 1) = 1e-300;
            CHECK_FALSE(isZero(zero, group));
            zero[group.first + k](0, 1) = -0.0;
            CHECK(isZero(zero, group));
        }
    }
}
