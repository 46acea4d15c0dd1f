// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

namespace sphinx {

// Records of `Size` doubles each, of eight particles that stand one after the other, transposed:
// component c of particle k is p[Size * k + c] in memory and a[c][k] in lanes. (A call that is not
// inlined writes all registers of the loop around it to memory.)

#if !defined(__AVX512F__)
namespace detail {
// Without registers of eight doubles GCC 12 makes single numbers of their permutations.

inline HalfLanes loadHalf(const double* p) {
    HalfLanes a;
    std::memcpy(&a, p, sizeof a);
    return a;
}
inline void storeHalf(HalfLanes a, double* p) { std::memcpy(p, &a, sizeof a); }
inline void setHalf(Lanes& a, int half, HalfLanes value) {
    std::memcpy(reinterpret_cast<char*>(&a) + static_cast<std::size_t>(half) * sizeof value, &value,
                sizeof value);
}
inline HalfLanes getHalf(const Lanes& a, int half) {
    HalfLanes value;
    std::memcpy(&value,
                reinterpret_cast<const char*>(&a) + static_cast<std::size_t>(half) * sizeof value,
                sizeof value);
    return value;
}
/// Rows and columns of four by four numbers change places.
inline void transpose(HalfLanes (&m)[4]) {
    const HalfLanes a = __builtin_shufflevector(m[0], m[1], 0, 4, 2, 6);
    const HalfLanes b = __builtin_shufflevector(m[0], m[1], 1, 5, 3, 7);
    const HalfLanes c = __builtin_shufflevector(m[2], m[3], 0, 4, 2, 6);
    const HalfLanes d = __builtin_shufflevector(m[2], m[3], 1, 5, 3, 7);
    m[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    m[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    m[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    m[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}
template <int Size>
[[gnu::always_inline]] inline void loadHalves(const double* p, Lanes a[Size]) {
    for (int half = 0; half < 2; ++half, p += 4 * Size) {
        if constexpr (Size == 2) {
            const HalfLanes b = loadHalf(p);
            const HalfLanes c = loadHalf(p + 4);
            setHalf(a[0], half, __builtin_shufflevector(b, c, 0, 2, 4, 6));
            setHalf(a[1], half, __builtin_shufflevector(b, c, 1, 3, 5, 7));
        } else {
            HalfLanes m[4] = {loadHalf(p), loadHalf(p + 4), loadHalf(p + 8), loadHalf(p + 12)};
            transpose(m);
            for (int c = 0; c < 4; ++c) setHalf(a[c], half, m[c]);
        }
    }
}
template <int Size>
[[gnu::always_inline]] inline void storeHalves(const Lanes a[Size], double* p) {
    for (int half = 0; half < 2; ++half, p += 4 * Size) {
        if constexpr (Size == 2) {
            const HalfLanes b = getHalf(a[0], half);
            const HalfLanes c = getHalf(a[1], half);
            storeHalf(__builtin_shufflevector(b, c, 0, 4, 1, 5), p);
            storeHalf(__builtin_shufflevector(b, c, 2, 6, 3, 7), p + 4);
        } else {
            HalfLanes m[4];
            for (int c = 0; c < 4; ++c) m[c] = getHalf(a[c], half);
            transpose(m);
            for (int k = 0; k < 4; ++k) storeHalf(m[k], p + 4 * k);
        }
    }
}
}  // namespace detail
#endif

template <int Size>
[[gnu::always_inline]] inline void loadRecords(const double* p, Lanes a[Size]) {
#if !defined(__AVX512F__)
    if constexpr (Size == 2 || Size == 4) return detail::loadHalves<Size>(p, a);
#endif
    if constexpr (Size == 1) {
        a[0] = loadLanes(p);
    } else if constexpr (Size == 2) {
        const Lanes b = loadLanes(p);
        const Lanes c = loadLanes(p + lane_count);
        a[0] = __builtin_shufflevector(b, c, 0, 2, 4, 6, 8, 10, 12, 14);
        a[1] = __builtin_shufflevector(b, c, 1, 3, 5, 7, 9, 11, 13, 15);
    } else if constexpr (Size == 4) {
        Lanes even[2], odd[2];  // components 0 and 1, 2 and 3 of four particles
        for (int half = 0; half < 2; ++half) {
            const Lanes b = loadLanes(p + (2 * half) * lane_count);
            const Lanes c = loadLanes(p + (2 * half + 1) * lane_count);
            even[half] = __builtin_shufflevector(b, c, 0, 4, 8, 12, 1, 5, 9, 13);
            odd[half] = __builtin_shufflevector(b, c, 2, 6, 10, 14, 3, 7, 11, 15);
        }
        a[0] = __builtin_shufflevector(even[0], even[1], 0, 1, 2, 3, 8, 9, 10, 11);
        a[1] = __builtin_shufflevector(even[0], even[1], 4, 5, 6, 7, 12, 13, 14, 15);
        a[2] = __builtin_shufflevector(odd[0], odd[1], 0, 1, 2, 3, 8, 9, 10, 11);
        a[3] = __builtin_shufflevector(odd[0], odd[1], 4, 5, 6, 7, 12, 13, 14, 15);
    } else {
        for (int c = 0; c < Size; ++c) {
            const auto at = [&](int k) { return p[Size * k + c]; };
            a[c] = Lanes{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
        }
    }
}

template <int Size>
[[gnu::always_inline]] inline void storeRecords(const Lanes a[Size], double* p) {
#if !defined(__AVX512F__)
    if constexpr (Size == 2 || Size == 4) return detail::storeHalves<Size>(a, p);
#endif
    if constexpr (Size == 1) {
        storeLanes(a[0], p);
    } else if constexpr (Size == 2) {
        storeLanes(__builtin_shufflevector(a[0], a[1], 0, 8, 1, 9, 2, 10, 3, 11), p);
        storeLanes(__builtin_shufflevector(a[0], a[1], 4, 12, 5, 13, 6, 14, 7, 15), p + lane_count);
    } else if constexpr (Size == 4) {
        // Components 0 and 1, 2 and 3 of four particles.
        const Lanes b[2] = {__builtin_shufflevector(a[0], a[1], 0, 8, 1, 9, 2, 10, 3, 11),
                            __builtin_shufflevector(a[0], a[1], 4, 12, 5, 13, 6, 14, 7, 15)};
        const Lanes c[2] = {__builtin_shufflevector(a[2], a[3], 0, 8, 1, 9, 2, 10, 3, 11),
                            __builtin_shufflevector(a[2], a[3], 4, 12, 5, 13, 6, 14, 7, 15)};
        for (int half = 0; half < 2; ++half) {
            storeLanes(__builtin_shufflevector(b[half], c[half], 0, 1, 8, 9, 2, 3, 10, 11),
                       p + (2 * half) * lane_count);
            storeLanes(__builtin_shufflevector(b[half], c[half], 4, 5, 12, 13, 6, 7, 14, 15),
                       p + (2 * half + 1) * lane_count);
        }
    } else {
        double one[Size][lane_count];
        for (int c = 0; c < Size; ++c) storeLanes(a[c], one[c]);
        for (int k = 0; k < lane_count; ++k)
            for (int c = 0; c < Size; ++c) p[Size * k + c] = one[c][k];
    }
}

}  // namespace sphinx
