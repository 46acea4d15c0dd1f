// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

namespace sphinx {

/// Records of three doubles of eight particles, transposed: out[c][k] = base[3 index[k] + c].
[[gnu::always_inline]] inline void gatherTriples(const double* base, const std::uint32_t* index,
                                                 Lanes out[3]) {
#if defined(__AVX512VL__)
    const auto row = [&](int k) {
        return reinterpret_cast<HalfLanes>(
            _mm256_maskz_loadu_pd(0x7, base + std::size_t{3} * index[k]));
    };
    const auto join = [](HalfLanes a, HalfLanes b) {
        return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Lanes c01 = join(row(0), row(1));
    const Lanes c23 = join(row(2), row(3));
    const Lanes c45 = join(row(4), row(5));
    const Lanes c67 = join(row(6), row(7));
    const Lanes a = __builtin_shufflevector(c01, c23, 0, 4, 8, 12, 1, 5, 9, 13);
    const Lanes b = __builtin_shufflevector(c45, c67, 0, 4, 8, 12, 1, 5, 9, 13);
    const Lanes c = __builtin_shufflevector(c01, c23, 2, 6, 10, 14, 3, 7, 11, 15);
    const Lanes d = __builtin_shufflevector(c45, c67, 2, 6, 10, 14, 3, 7, 11, 15);
    out[0] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    out[1] = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    out[2] = __builtin_shufflevector(c, d, 0, 1, 2, 3, 8, 9, 10, 11);
#else
    for (int c = 0; c < 3; ++c) out[c] = gatherStrided<3>(base + c, index);
#endif
}

}  // namespace sphinx
