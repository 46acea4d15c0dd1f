// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/tile.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace sphinx;

namespace {

/// 100 i + 10 j + the component in the lane of each pair.
FloatTile numbered(int component) {
    FloatTile a;
    for (int i = 0; i < tile_side; ++i)
        for (int j = 0; j < tile_side; ++j)
            a[tile_side * i + j] = static_cast<float>(100 * i + 10 * j + component);
    return a;
}

template <int N>
void checkSums() {
    ExactTile terms[N];
    for (int c = 0; c < N; ++c) terms[c] = ExactTile(numbered(c));
    constexpr int stride = sum_stride<N>;
    std::vector<ExactNumber> sums(9 * stride, 1);
    addOverJ<N>(terms, sums.data());
    for (int i = 0; i < tile_side; ++i)
        for (int c = 0; c < N; ++c)
            CHECK(fromExact(sums[i * stride + c]) == 1 + 400 * i + 60 + 4 * c);

    sums.assign(9 * stride, 1);
    const std::uint32_t slots[tile_side] = {7, 0, 8, 3};
    addOverI<N, -1>(terms, slots, sums.data());
    addOverI<N, 1>(terms, slots, sums.data());
    addOverI<N, 1>(terms, slots, sums.data());
    for (int j = 0; j < tile_side; ++j)
        for (int c = 0; c < N; ++c)
            CHECK(fromExact(sums[slots[j] * stride + c]) == 1 + 600 + 40 * j + 4 * c);
    for (const int other : {1, 2, 4, 5, 6})
        for (int c = 0; c < N; ++c) CHECK(sums[other * stride + c] == 1);
}

}  // namespace

TEST_CASE("sums of a tile over j and over i") {
    checkSums<1>();
    checkSums<2>();
    checkSums<3>();
}

TEST_CASE("terms of a tile are rounded to whole numbers, to the even one of two as near") {
    FloatTile a = {};
    a[0] = 0.5f;
    a[1] = 1.5f;
    a[5] = -2.5f;
    a[9] = 0x1p45f;
    a[15] = -0.6f;
    const ExactTile b(a);
    CHECK(b.low[0] == 0);
    CHECK(b.low[1] == 2);
    CHECK(fromExact(b.low[5]) == -2);
    CHECK(b.high[1] == 0x1p45);
    CHECK(fromExact(b.high[7]) == -1);
}

TEMPLATE_TEST_CASE("words of four particles in the lanes of their pairs", "", float, double) {
    using Real = TestType;
    Real records[5 * 8];
    for (int k = 0; k < 5 * 8; ++k) records[k] = static_cast<Real>(k);
    const std::uint32_t at[tile_side] = {4, 0, 3, 1};
    const auto check = [&]<int Words, int Size>() {
        TileOf<Real> of_i[Size], of_j[Size];
        gatherOfEach<Of::i, Words>(records, at, of_i);
        gatherOfEach<Of::j, Words>(records, at, of_j);
        for (int c = 0; c < Words; ++c)
            for (int i = 0; i < tile_side; ++i)
                for (int j = 0; j < tile_side; ++j) {
                    CHECK(of_i[c][tile_side * i + j] == Size * at[i] + static_cast<unsigned>(c));
                    CHECK(of_j[c][tile_side * i + j] == Size * at[j] + static_cast<unsigned>(c));
                }
    };
    check.template operator()<4, 4>();
    check.template operator()<6, 8>();
    check.template operator()<8, 8>();
}

TEST_CASE("roots and places of a tile") {
    FloatTile a;
    for (int k = 0; k < tile_size; ++k) a[k] = std::pow(10.0f, static_cast<float>(4 * k - 30));
    const FloatTile roots = inverseSqrtTile(a);
    for (int k = 0; k < tile_size; ++k)
        CHECK(roots[k] == Approx(1 / std::sqrt(static_cast<double>(a[k]))).epsilon(4e-7));

    std::uint32_t places[tile_size] = {};
    writePlaces(0x8005, 100, places);
    CHECK(places[0] == 100);
    CHECK(places[1] == 102);
    CHECK(places[2] == 115);
    CHECK(lessBits(a, tile(1e-20f)) == 0x7);

    std::uint8_t flags[40 + 3] = {};
    flags[7] = 1;
    std::uint32_t at[20];
    for (std::uint32_t k = 0; k < 20; ++k) at[k] = 8 + k;
    CHECK_FALSE(anyOf(flags, at, 20));
    at[18] = 7;
    CHECK(anyOf(flags, at, 20));
    CHECK_FALSE(anyOf(flags, at, 18));
    CHECK(anyOf(flags, at, 19));

    WholeTile whole = {};
    whole[3] = 7;
    whole[8] = -9;
    CHECK(lowLanes(whole)[3] == 7);
    CHECK(highLanes(whole)[0] == -9);
    CHECK(joinFloats(lowLanes(whole), highLanes(whole))[8] == -9);
    CHECK(DoubleTile{lowLanes(whole), highLanes(whole)}[8] == -9);
}

TEST_CASE("differences of places go round at 2^32") {
    WholeTile a = {}, b = {};
    a[3] = -2120155944;
    b[3] = 1559010980;
    a[15] = 7;
    b[15] = 9;
    const WholeTile d = wrappedDifference(a, b);
    CHECK(d[3] == 615800372);
    CHECK(d[15] == -2);
    CHECK(d[0] == 0);
}

TEST_CASE("larger and smaller numbers of tiles, and where they are smaller") {
    FloatTile a = numbered(0), b = tile(150);
    b[7] = a[7];
    const FloatTile larger = maxTile(a, b), smaller = minTile(a, b);
    unsigned less = 0;
    for (int k = 0; k < tile_size; ++k) {
        CHECK(larger[k] == std::max(a[k], b[k]));
        CHECK(smaller[k] == std::min(a[k], b[k]));
        less |= a[k] < b[k] ? 1u << k : 0u;
    }
    CHECK(lessBits(a, b) == less);
    CHECK(lessBits(b, a) == (0xffffu & ~less & ~(1u << 7)));
}
