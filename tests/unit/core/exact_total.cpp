// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/exact_total.h"
#include "core/sum_all.h"
#include "core/types.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace sphinx;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double total(const std::vector<double>& terms) {
    ExactTotal sum;
    for (const double term : terms) sum.add(term);
    return sum.value();
}

/// Of both signs and, over `range` powers of two, of any size.
std::vector<double> terms(std::size_t n, int range, std::mt19937_64& random) {
    std::vector<double> values(n);
    for (double& value : values) {
        const double size = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
        value =
            std::ldexp(size, static_cast<int>(random() % static_cast<unsigned>(range)) - range / 2);
    }
    return values;
}

}  // namespace

TEST_CASE("a total is the sum, rounded once") {
    CHECK(total({}) == 0);
    CHECK(total({0.1}) == 0.1);
    CHECK(total({-0.1, 0.3}) == 0.3 - 0.1);
    CHECK(total({1e16, 1, -1e16}) == 1);
    // Halfway to the next number: to the even one, unless anything below decides.
    CHECK(total({1, 0x1p-53}) == 1);
    CHECK(total({1 + 0x1p-52, 0x1p-53}) == 1 + 0x1p-51);
    CHECK(total({1, 0x1p-53, 0x1p-1000}) == 1 + 0x1p-52);
    CHECK(total({-1, -0x1p-53, -0x1p-1000}) == -1 - 0x1p-52);
    CHECK(total({1, 0x1p-53, -0x1p-1000}) == 1);
}

TEST_CASE("a total of the largest and of the smallest numbers") {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double smallest = std::numeric_limits<double>::denorm_min();
    CHECK(total({largest, largest, -largest}) == largest);
    CHECK(total({largest, largest}) == infinity);
    CHECK(total({-largest, -largest}) == -infinity);
    CHECK(total({smallest, smallest, smallest}) == 3 * smallest);
    CHECK(total({0x1p-1022, -smallest}) == 0x1p-1022 - smallest);
}

TEST_CASE("a total is not finite as soon as a term is not") {
    CHECK(std::isnan(total({1, nan_value, 2})));
    CHECK(total({1, infinity, 2}) == infinity);
    CHECK(total({1, -infinity, 2}) == -infinity);
    CHECK(std::isnan(total({infinity, -infinity})));
}

TEST_CASE("a total has the same bits in any order and however it is shared out") {
    std::mt19937_64 random(5);
    const int range = GENERATE(1, 30, 1900);
    std::vector<double> values = terms(10000, range, random);
    const double sum = total(values);
    CHECK(std::isfinite(sum));
    for (int k = 0; k < 5; ++k) {
        std::shuffle(values.begin(), values.end(), random);
        CHECK(total(values) == sum);
        ExactTotal parts[3];
        for (const double value : values) parts[random() % 3].add(value);
        parts[0] += parts[1];
        parts[0] += parts[2];
        CHECK(parts[0].value() == sum);
    }
    // What is added and taken away again leaves nothing.
    for (std::size_t k = 0; k < 10000; ++k) values.push_back(-values[k]);
    std::shuffle(values.begin(), values.end(), random);
    CHECK(total(values) == 0);
}

TEST_CASE("terms that come many at a time give the same total") {
    std::mt19937_64 random(11);
    // On two grids, beyond them, and where there is none: too large, too small, not finite.
    const int range = GENERATE(1, 30, 60, 100, 1900);
    for (const std::size_t n :
         {std::size_t{0}, std::size_t{1}, std::size_t{9}, ExactTotal::batch}) {
        std::vector<double> values = terms(n, range, random);
        const double expected = total(values);
        values.resize(detail::padded(n));
        ExactTotal sum;
        sum.addBatch(values.data(), n);
        CHECK(sum.value() == expected);
    }
    const std::vector<double> equal(ExactTotal::batch, -1 - 0x1p-52);
    const auto add = [](ExactTotal& to, std::vector<double> changed) {
        to.addBatch(changed.data(), changed.size());
    };
    ExactTotal sum;
    for (int k = 0; k < 10; ++k) add(sum, equal);
    CHECK(sum.value() == -10.0 * ExactTotal::batch * (1 + 0x1p-52));
    for (const double fault : {nan_value, infinity}) {
        std::vector<double> spoilt = equal;
        spoilt[3] = fault;
        ExactTotal total;
        add(total, spoilt);
        CHECK(!std::isfinite(total.value()));
    }
}

TEST_CASE("a total of many equal terms passes its carries on") {
    ExactTotal sum, other;
    for (int k = 0; k < 5000; ++k) sum.add(-1 - 0x1p-52);
    CHECK(sum.value() == -5000 * (1 + 0x1p-52));
    for (int k = 0; k < 5000; ++k) {
        ExactTotal one;
        one.add(3);
        other += one;
    }
    CHECK(other.value() == 15000);
}

TEST_CASE("a sum over particles depends neither on their order nor on the threads") {
    std::mt19937_64 random(7);
    std::vector<double> values = terms(5000, 60, random);
    const double expected = total(values);
    for (const int threads : {1, 3}) {
        setThreadCount(threads);
        std::shuffle(values.begin(), values.end(), random);
        const double sum = sumAll(values.size(), [&](std::size_t i) { return values[i]; });
        CHECK(sum == expected);
        const Vec<3> vector =
            sumAll(values.size(), [&](std::size_t i) { return Vec<3>(values[i], -values[i], 1); });
        CHECK(vector == Vec<3>(expected, -expected, 5000));
    }
    setThreadCount(1);
    CHECK(sumAll(0, [](std::size_t) { return 1.0; }) == 0);
    CHECK(countLocal(10, [](std::size_t i) { return i % 3 == 0; }) == 4);
    CHECK(maxAll(10, -1, [](std::size_t i) { return static_cast<double>(i % 7); }) == 6);
    CHECK(maxAll(0, -1, [](std::size_t) { return 5.0; }) == -1);
}
