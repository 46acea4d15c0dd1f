// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/wide.h"

#include <catch2/catch.hpp>

#include <array>

using namespace sphinx;

namespace {

using Eight = std::array<double, lane_count>;
constexpr Eight left{1, -2, 0.5, 4, -0.25, 6, 3, -8};
constexpr Eight right{2, -2, 3, -1, 0.125, 7, -3, 0.1};

Wide load(const Eight& a) { return loadLanes(a.data()); }

/// f of numbers and of eight at once.
template <class F>
void checkEach(F&& f) {
    const Wide together = f(load(left), load(right));
    for (int k = 0; k < lane_count; ++k) CHECK(together[k] == f(left[k], right[k]));
}
template <class F>
void checkMask(F&& f) {
    const LaneMask mask = f(load(left), load(right));
    for (int k = 0; k < lane_count; ++k) CHECK((mask[k] != 0) == f(left[k], right[k]));
}

}  // namespace

TEST_CASE("arithmetic of eight numbers is that of each") {
    using std::abs, std::exp, std::log1p, std::max, std::sqrt;
    checkEach([](auto a, auto b) { return a + b; });
    checkEach([](auto a, auto b) { return a - b; });
    checkEach([](auto a, auto b) { return a * b; });
    checkEach([](auto a, auto b) { return a / b; });
    checkEach([](auto a, auto b) { return a += b; });
    checkEach([](auto a, auto b) { return a -= b; });
    checkEach([](auto a, auto b) { return a *= b; });
    checkEach([](auto a, auto b) { return a /= b; });
    checkEach([](auto a, auto b) { return max(a, b); });
    checkEach([](auto a, auto) { return abs(a); });
    checkEach([](auto a, auto) { return sqrt(abs(a)); });
    checkEach([](auto a, auto) { return exp(a); });
    checkEach([](auto a, auto) { return log1p(abs(a)); });
}

TEST_CASE("comparisons of eight numbers are those of each") {
    checkMask([](auto a, auto b) { return a < b; });
    checkMask([](auto a, auto b) { return a > b; });
    checkMask([](auto a, auto b) { return a != b; });
    const Wide chosen = select(load(left) < load(right), load(left), load(right));
    for (int k = 0; k < lane_count; ++k) CHECK(chosen[k] == std::min(left[k], right[k]));
    CHECK(maskBits(always<Wide>()) == all_lanes);
    CHECK(always<double>());
}

TEST_CASE("the larger of a number and what is none is the number on the left") {
    Eight none;
    none.fill(nan_value);
    const Wide kept = max(load(left), load(none));
    for (int k = 0; k < lane_count; ++k) CHECK(kept[k] == left[k]);
    CHECK(maxOf(load(left)) == 6);
}

TEST_CASE("matrices of eight are eight matrices") {
    MatOf<2, Wide> a;
    VecOf<2, Wide> x;
    for (int c = 0; c < 4; ++c) a.data()[c] = load(left) * Wide(c - 1.5);
    for (int c = 0; c < 2; ++c) x[c] = load(right) + Wide(c);
    const VecOf<2, Wide> product = a * x * 2.0;
    for (int k = 0; k < lane_count; ++k) {
        Mat<2> b;
        Vec<2> y;
        for (int c = 0; c < 4; ++c) b.data()[c] = a.data()[c][k];
        for (int c = 0; c < 2; ++c) y[c] = x[c][k];
        const Vec<2> one = b * y * 2.0;
        for (int c = 0; c < 2; ++c) CHECK(product[c][k] == Approx(one[c]).epsilon(1e-15));
    }
}
