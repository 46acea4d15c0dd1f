// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/records.h"

#include <catch2/catch.hpp>

#include <numeric>
#include <vector>

using namespace sphinx;

// Records of any size are transposed by a plain loop, those of one, two and four by shuffles.
TEMPLATE_TEST_CASE_SIG("records are transposed and back", "", ((int Size), Size), 1, 2, 3, 4, 6,
                       9) {
    std::vector<double> p(Size * lane_count);
    std::iota(p.begin(), p.end(), 1.0);
    Lanes a[Size];
    loadRecords<Size>(p.data(), a);
    for (int c = 0; c < Size; ++c)
        for (int k = 0; k < lane_count; ++k) CHECK(a[c][k] == p[Size * k + c]);

    // Beyond the eight records nothing is written.
    std::vector<double> stored(Size * lane_count + 1, -1.0);
    storeRecords<Size>(a, stored.data());
    CHECK(stored.back() == -1.0);
    stored.pop_back();
    CHECK(stored == p);
}
