// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace sphinx {

/// lane_count neighbors at a time. Vector types of the compiler (GCC and Clang), so the same code
/// becomes AVX-512, AVX2, SSE2 or NEON.
using Lanes = double __attribute__((vector_size(64)));
using FloatLanes = float __attribute__((vector_size(32)));
/// The pairs of four particles with four others (core/tile.h).
using FloatTile = float __attribute__((vector_size(64)));
using HalfLanes = double __attribute__((vector_size(32)));
using LaneMask = std::int64_t __attribute__((vector_size(64)));
using WholeLanes = std::int32_t __attribute__((vector_size(32)));

inline Lanes lanes(double a) { return Lanes{a, a, a, a, a, a, a, a}; }

inline Lanes loadLanes(const double* p) {
    Lanes a;
    std::memcpy(&a, p, sizeof a);
    return a;
}
/// Conversions in one instruction, where GCC 12 makes two halves of __builtin_convertvector. (The
/// forms with a full mask: those without read a variable that GCC thinks uninitialised.)
inline Lanes toLanes(FloatLanes a) {
#if defined(__AVX512F__)
    return reinterpret_cast<Lanes>(_mm512_maskz_cvtps_pd(0xff, reinterpret_cast<__m256>(a)));
#else
    return __builtin_convertvector(a, Lanes);
#endif
}
inline FloatLanes toFloat(Lanes a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatLanes>(_mm512_maskz_cvtpd_ps(0xff, reinterpret_cast<__m512d>(a)));
#else
    return __builtin_convertvector(a, FloatLanes);
#endif
}

inline Lanes loadLanes(const std::int32_t* p) {
    WholeLanes a;
    std::memcpy(&a, p, sizeof a);
#if defined(__AVX512F__)
    return reinterpret_cast<Lanes>(_mm512_maskz_cvtepi32_pd(0xff, reinterpret_cast<__m256i>(a)));
#else
    return __builtin_convertvector(a, Lanes);
#endif
}
inline void storeLanes(Lanes a, double* p) { std::memcpy(p, &a, sizeof a); }
/// Rounded to the nearest whole numbers, which must be below 2^31.
inline void storeLanes(Lanes a, std::int32_t* p) {
#if defined(__AVX512F__)
    const auto b =
        reinterpret_cast<WholeLanes>(_mm512_maskz_cvtpd_epi32(0xff, reinterpret_cast<__m512d>(a)));
#else
    constexpr double shift = 0x1.8p52;  // beside it a double has no fraction
    const WholeLanes b = __builtin_convertvector((a + shift) - shift, WholeLanes);
#endif
    std::memcpy(p, &b, sizeof b);
}

inline Lanes maxLanes(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes minLanes(Lanes a, Lanes b) { return a < b ? a : b; }

/// The same in doubles: the first two of the four, and the others. (Of one vector of sixteen
/// doubles GCC 12 makes single numbers.)
struct DoubleTile {
    Lanes low = {}, high = {};

    double operator[](int k) const { return k < lane_count ? low[k] : high[k - lane_count]; }
    DoubleTile operator-() const { return {-low, -high}; }
    DoubleTile& operator+=(const DoubleTile& b) { return *this = *this + b; }
    DoubleTile& operator*=(const DoubleTile& b) { return *this = *this * b; }
    friend DoubleTile operator+(const DoubleTile& a, const DoubleTile& b) {
        return {a.low + b.low, a.high + b.high};
    }
    friend DoubleTile operator-(const DoubleTile& a, const DoubleTile& b) {
        return {a.low - b.low, a.high - b.high};
    }
    friend DoubleTile operator*(const DoubleTile& a, const DoubleTile& b) {
        return {a.low * b.low, a.high * b.high};
    }
    friend DoubleTile operator/(const DoubleTile& a, const DoubleTile& b) {
        return {a.low / b.low, a.high / b.high};
    }
    friend DoubleTile operator+(double a, const DoubleTile& b) { return {a + b.low, a + b.high}; }
    friend DoubleTile operator*(double a, const DoubleTile& b) { return {a * b.low, a * b.high}; }
    friend DoubleTile operator*(const DoubleTile& a, double b) { return b * a; }
};

inline FloatTile tile(float a) { return FloatTile{a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a}; }
inline FloatTile maxTile(FloatTile a, FloatTile b) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_max_ps(0xffff, reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b)));
#else
    return a > b ? a : b;
#endif
}
inline FloatTile minTile(FloatTile a, FloatTile b) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_min_ps(0xffff, reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b)));
#else
    return a < b ? a : b;
#endif
}

template <class V>
inline V sqrtLanes(V a) {
    V r = a;
#pragma omp simd
    for (int k = 0; k < lane_count; ++k) r[k] = std::sqrt(a[k]);
    return r;
}

/// 1/sqrt(a) to the last two or three bits, for a from 1e-30 to 1e30: an estimate, and steps that
/// square (Newton) or cube (Halley) its error.
inline Lanes inverseSqrtLanes(Lanes a) {
#if defined(__AVX512F__)
    const Lanes half = 0.5 * a;
    Lanes x = reinterpret_cast<Lanes>(_mm512_maskz_rsqrt14_pd(0xff, reinterpret_cast<__m512d>(a)));
    x *= 1.5 - half * x * x;
    return x * (1.5 - half * x * x);
#else
    // In single precision the error is 1.5e-7: too much for one of Newton's steps.
    const Lanes x = toLanes(1.0f / sqrtLanes(toFloat(a)));
    const Lanes e = 1.0 - a * x * x;
    return x + x * (e * (0.5 + 0.375 * e));
#endif
}

/// Sum over the lanes, always in the same order.
inline double sumLanes(Lanes a) {
    using Pair = double __attribute__((vector_size(16)));
    const HalfLanes h =
        __builtin_shufflevector(a, a, 0, 1, 2, 3) + __builtin_shufflevector(a, a, 4, 5, 6, 7);
    const Pair q = __builtin_shufflevector(h, h, 0, 1) + __builtin_shufflevector(h, h, 2, 3);
    return q[0] + q[1];
}

/// The sums of four, each as sumLanes() makes it.
inline HalfLanes sumLanes(Lanes a, Lanes b, Lanes c, Lanes d) {
    const auto half = [](Lanes v) {
        return __builtin_shufflevector(v, v, 0, 1, 2, 3) +
               __builtin_shufflevector(v, v, 4, 5, 6, 7);
    };
    const auto quarters = [](HalfLanes v, HalfLanes w) {
        return __builtin_shufflevector(v, w, 0, 1, 4, 5) +
               __builtin_shufflevector(v, w, 2, 3, 6, 7);
    };
    const HalfLanes ab = quarters(half(a), half(b));
    const HalfLanes cd = quarters(half(c), half(d));
    return __builtin_shufflevector(ab, cd, 0, 2, 4, 6) +
           __builtin_shufflevector(ab, cd, 1, 3, 5, 7);
}

/// Bit k is set where lane k of a comparison is true.
inline unsigned maskBits(LaneMask mask) {
#if defined(__AVX512DQ__)
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask));
#else
    unsigned bits = 0;
    for (int k = 0; k < lane_count; ++k) bits |= mask[k] ? 1u << k : 0u;
    return bits;
#endif
}
/// maskBits() where a comparison is true in every lane.
inline constexpr unsigned all_lanes = 0xff;

/// Bit k is set where a[k] < b[k].
inline unsigned lessBits(Lanes a, Lanes b) {
#if defined(__AVX512F__)
    return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b),
                              _CMP_LT_OQ);
#else
    return maskBits(a < b);
#endif
}
/// Bit k is set where p[k] is not b.
inline unsigned differBits(const std::int32_t* p, std::int32_t b) {
    WholeLanes a;
    std::memcpy(&a, p, sizeof a);
#if defined(__AVX512VL__)
    return _mm256_cmpneq_epi32_mask(reinterpret_cast<__m256i>(a), _mm256_set1_epi32(b));
#else
    unsigned bits = 0;
    for (int k = 0; k < lane_count; ++k) bits |= a[k] != b ? 1u << k : 0u;
    return bits;
#endif
}

/// p[index[k]] of eight particles.
template <class Index>
inline Lanes gatherLanes(const double* p, const Index* index) {
    return Lanes{p[index[0]], p[index[1]], p[index[2]], p[index[3]],
                 p[index[4]], p[index[5]], p[index[6]], p[index[7]]};
}

/// One double of records of `Stride` doubles: base[Stride * index[k]].
template <int Stride, class Index>
inline Lanes gatherStrided(const double* base, const Index* index) {
    const auto at = [&](int k) { return base[std::size_t{Stride} * index[k]]; };
    return Lanes{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}

/// The first four doubles of records of `Stride` doubles, of eight particles, transposed:
/// out[c][k] = base[Stride * index[k] + c]. Loads and shuffles beat hardware gathers. (A call that
/// is not inlined writes all registers of the loop around it to memory.)
template <int Stride, class Index>
[[gnu::always_inline]] inline void gatherRecords(const double* base, const Index* index,
                                                 Lanes out[4]) {
    const auto row = [&](int k) {
        HalfLanes a;
        std::memcpy(&a, base + std::size_t{Stride} * index[k], sizeof a);
        return a;
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
    out[3] = __builtin_shufflevector(c, d, 4, 5, 6, 7, 12, 13, 14, 15);
}

/// Records of two doubles, in the same way.
[[gnu::always_inline]] inline void gatherPairs(const double* base, const std::uint32_t* index,
                                               Lanes out[2]) {
    using Pair = double __attribute__((vector_size(16)));
    const auto row = [&](int k) {
        Pair a;
        std::memcpy(&a, base + std::size_t{2} * index[k], sizeof a);
        return a;
    };
    const auto join = [&](int k) {
        return __builtin_shufflevector(row(k), row(k + 1), 0, 1, 2, 3);
    };
    const auto joinHalves = [](HalfLanes a, HalfLanes b) {
        return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Lanes a = joinHalves(join(0), join(2));
    const Lanes b = joinHalves(join(4), join(6));
    out[0] = __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
    out[1] = __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15);
}

}  // namespace sphinx
