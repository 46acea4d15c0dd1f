// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
// Every function against a plain loop. Also built for other processors than this one, see
// tests/CMakeLists.txt.
#include "core/lanes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

using namespace sphinx;

namespace {

using Eight = std::array<double, lane_count>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Eight special{0.0, -0.0, 1.0, -1.0, infinity, -infinity, nan_value, 1e-310};

Eight randomEight(unsigned seed, double scale = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-scale, scale);
    Eight values;
    for (double& value : values) value = any(random);
    return values;
}

Lanes load(const Eight& a) { return loadLanes(a.data()); }
Eight values(Lanes a) {
    Eight stored;
    storeLanes(a, stored.data());
    return stored;
}

/// As they stand in memory: a NaN is itself, and -0 is not 0.
template <class Values>
bool sameBits(const Values& a, const Values& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class F>
Eight each(const Eight& a, const Eight& b, F&& f) {
    Eight c;
    for (int k = 0; k < lane_count; ++k) c[k] = f(a[k], b[k]);
    return c;
}
template <class F>
unsigned bitsWhere(F&& f) {
    unsigned bits = 0;
    for (int k = 0; k < lane_count; ++k)
        if (f(k)) bits |= 1u << k;
    return bits;
}

}  // namespace

TEST_CASE("lanes are loaded and stored as they stand in memory") {
    for (const Eight& a : {special, randomEight(1)}) {
        CHECK(sameBits(values(load(a)), a));
    }
    for (int k = 0; k < lane_count; ++k) CHECK(load(randomEight(1))[k] == randomEight(1)[k]);
    for (double value : values(lanes(0.1))) CHECK(value == 0.1);
}

TEST_CASE("lanes of float are rounded, and exact in double") {
    const Eight a = randomEight(2, 1e3);
    const FloatLanes floats = toFloat(load(a));
    const Eight back = values(toLanes(floats));
    for (int k = 0; k < lane_count; ++k) {
        CHECK(floats[k] == static_cast<float>(a[k]));
        CHECK(back[k] == static_cast<double>(static_cast<float>(a[k])));
    }
}

TEST_CASE("whole numbers are loaded exactly and stored rounded, halves to even") {
    const std::array<std::int32_t, lane_count> whole{0,          1,           -1,    7,
                                                     2147483647, -2147483647, 65536, -3};
    const Eight loaded = values(loadLanes(whole.data()));
    for (int k = 0; k < lane_count; ++k) CHECK(loaded[k] == whole[k]);

    const Eight a{0.5, 1.5, -0.5, -1.5, 2.5, 2147483646.75, -7.49999, 1e-9};
    std::array<std::int32_t, lane_count> stored;
    storeLanes(load(a), stored.data());
    for (int k = 0; k < lane_count; ++k) CHECK(stored[k] == std::nearbyint(a[k]));
}

TEST_CASE("the larger and the smaller of lanes, the second where one is no number") {
    const Eight a = special;
    for (const Eight& b : {randomEight(3), Eight{nan_value, 0, nan_value, 1, 1, 1, 1, -1}}) {
        CHECK(sameBits(values(maxLanes(load(a), load(b))),
                       each(a, b, [](double x, double y) { return x > y ? x : y; })));
        CHECK(sameBits(values(minLanes(load(a), load(b))),
                       each(a, b, [](double x, double y) { return x < y ? x : y; })));
    }
}

TEST_CASE("roots of lanes are those of numbers") {
    Eight a = randomEight(4, 1e5);
    for (double& value : a) value = std::abs(value);
    const Eight roots = values(sqrtLanes(load(a)));
    const FloatLanes float_roots = sqrtLanes(toFloat(load(a)));
    for (int k = 0; k < lane_count; ++k) {
        CHECK(roots[k] == std::sqrt(a[k]));
        CHECK(float_roots[k] == std::sqrt(static_cast<float>(a[k])));
    }
}

TEST_CASE("inverse roots are right to the last bits from 1e-30 to 1e30") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-30, 30);
    double worst = 0;
    for (int n = 0; n < 1000; ++n) {
        Eight a;
        for (double& value : a) value = std::pow(10, exponent(random));
        if (n == 0) a[0] = 1e-30, a[1] = 1e30, a[2] = 1;
        const Eight inverse = values(inverseSqrtLanes(load(a)));
        for (int k = 0; k < lane_count; ++k)
            worst = std::max(worst, std::abs(inverse[k] * std::sqrt(a[k]) - 1));
    }
    CHECK(worst < 8 * std::numeric_limits<double>::epsilon());
}

TEST_CASE("sums over lanes have one order") {
    std::array<Eight, 4> a;
    for (unsigned n = 0; n < 4; ++n) a[n] = randomEight(6 + n);
    const HalfLanes sums = sumLanes(load(a[0]), load(a[1]), load(a[2]), load(a[3]));
    for (int n = 0; n < 4; ++n) {
        const Eight& t = a[n];
        const double sum = ((t[0] + t[4]) + (t[2] + t[6])) + ((t[1] + t[5]) + (t[3] + t[7]));
        CHECK(sumLanes(load(t)) == sum);
        CHECK(sums[n] == sum);
    }
}

TEST_CASE("comparisons as bits") {
    const Eight a{1, 2, nan_value, -0.0, 5, -6, infinity, 8};
    const Eight b{2, 1, 3, 0.0, 5, -5, nan_value, 9};
    CHECK(lessBits(load(a), load(b)) == bitsWhere([&](int k) { return a[k] < b[k]; }));
    CHECK(maskBits(load(a) == load(b)) == bitsWhere([&](int k) { return a[k] == b[k]; }));
    CHECK(maskBits(load(a) != load(b)) == bitsWhere([&](int k) { return a[k] != b[k]; }));
    CHECK(maskBits(lanes(1) < lanes(2)) == all_lanes);
    CHECK(maskBits(lanes(2) < lanes(1)) == 0);

    const std::array<std::int32_t, lane_count> whole{3, 0, 3, -3, 3, 3, 1, 3};
    CHECK(differBits(whole.data(), 3) == bitsWhere([&](int k) { return whole[k] != 3; }));
}

namespace {

constexpr std::array<std::uint32_t, lane_count> scattered{9, 0, 3, 3, 11, 7, 1, 10};

template <int Stride>
void checkGatherRecords() {
    std::vector<double> records(12 * Stride);
    for (std::size_t n = 0; n < records.size(); ++n) records[n] = n;
    Lanes out[4];
    gatherRecords<Stride>(records.data(), scattered.data(), out);
    for (int c = 0; c < 4; ++c)
        for (int k = 0; k < lane_count; ++k) CHECK(out[c][k] == records[Stride * scattered[k] + c]);
}

}  // namespace

TEST_CASE("gathered lanes are those of the particles asked for") {
    std::vector<double> numbers(24);
    for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] = n;
    const Lanes single = gatherLanes(numbers.data(), scattered.data());
    Lanes pairs[2];
    gatherPairs(numbers.data(), scattered.data(), pairs);
    for (int k = 0; k < lane_count; ++k) {
        CHECK(single[k] == numbers[scattered[k]]);
        for (int c = 0; c < 2; ++c) CHECK(pairs[c][k] == numbers[2 * scattered[k] + c]);
    }
    checkGatherRecords<4>();
    checkGatherRecords<5>();
    checkGatherRecords<8>();
}
