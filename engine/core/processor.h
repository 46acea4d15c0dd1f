// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Vectors, and all that is written in instructions of a processor: what the compiler does not make
// well of them. Everything else is written for any.
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

inline constexpr int tile_side = 4;
inline constexpr int tile_size = tile_side * tile_side;

/// The pairs of four particles with four others (core/tile.h).
using WholeTile = std::int32_t __attribute__((vector_size(64)));

inline Lanes lanes(double a) { return Lanes{a, a, a, a, a, a, a, a}; }
inline FloatTile tile(float a) { return FloatTile{a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a}; }

/// What the processor has a register for. Of a choice between longer vectors, and of their
/// comparison, GCC 12 makes single numbers.
#if defined(__AVX512F__)
inline constexpr int part_bytes = 64;
#elif defined(__AVX__)
inline constexpr int part_bytes = 32;
#else
inline constexpr int part_bytes = 16;
#endif
using FloatPart = float __attribute__((vector_size(part_bytes)));
using DoublePart = double __attribute__((vector_size(part_bytes)));

template <class Part>
struct Parts {
    static constexpr int count = 64 / part_bytes;
    Part of[count];
};
/// f of each part of a and b.
template <class Part, class Vector, class F>
[[gnu::always_inline]] inline Vector byParts(Vector a, Vector b, F f) {
    auto x = __builtin_bit_cast(Parts<Part>, a);
    const auto y = __builtin_bit_cast(Parts<Part>, b);
    for (int k = 0; k < Parts<Part>::count; ++k) x.of[k] = f(x.of[k], y.of[k]);
    return __builtin_bit_cast(Vector, x);
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
inline Lanes toLanes(WholeLanes a) {
#if defined(__AVX512F__)
    return reinterpret_cast<Lanes>(_mm512_maskz_cvtepi32_pd(0xff, reinterpret_cast<__m256i>(a)));
#else
    return __builtin_convertvector(a, Lanes);
#endif
}
inline FloatTile toFloat(WholeTile a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_cvtepi32_ps(0xffff, reinterpret_cast<__m512i>(a)));
#else
    return __builtin_convertvector(a, FloatTile);
#endif
}
/// Rounded to the nearest whole numbers, which must be below 2^31.
inline WholeLanes toWhole(Lanes a) {
#if defined(__AVX512F__)
    return reinterpret_cast<WholeLanes>(
        _mm512_maskz_cvtpd_epi32(0xff, reinterpret_cast<__m512d>(a)));
#else
    constexpr double shift = 0x1.8p52;  // beside it a double has no fraction
    return __builtin_convertvector((a + shift) - shift, WholeLanes);
#endif
}

#if defined(__AVX512F__) || defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define SPHINX_HAS_FUSED
/// a b + c with one rounding.
inline Lanes fused(Lanes a, Lanes b, Lanes c) {
#if defined(__AVX512F__)
    return reinterpret_cast<Lanes>(_mm512_fmadd_pd(
        reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b), reinterpret_cast<__m512d>(c)));
#else
    for (int k = 0; k < lane_count; ++k) c[k] = __builtin_fma(a[k], b[k], c[k]);
    return c;
#endif
}
#endif

inline FloatTile maxTile(FloatTile a, FloatTile b) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_max_ps(0xffff, reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b)));
#else
    return byParts<FloatPart>(a, b, [](FloatPart x, FloatPart y) { return x > y ? x : y; });
#endif
}
inline FloatTile minTile(FloatTile a, FloatTile b) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_min_ps(0xffff, reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b)));
#else
    return byParts<FloatPart>(a, b, [](FloatPart x, FloatPart y) { return x < y ? x : y; });
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
/// 1/sqrt(a) to the last two or three bits, for a from 1e-30 to 1e30.
inline FloatTile inverseSqrtTile(FloatTile a) {
#if defined(__AVX512F__)
    const auto x =
        reinterpret_cast<FloatTile>(_mm512_maskz_rsqrt14_ps(0xffff, reinterpret_cast<__m512>(a)));
    const auto rest = reinterpret_cast<FloatTile>(
        _mm512_fnmadd_ps(reinterpret_cast<__m512>(0.5f * a * x), reinterpret_cast<__m512>(x),
                         reinterpret_cast<__m512>(tile(1.5f))));
    return x * rest;
#else
    FloatTile r = a;
#pragma omp simd
    for (int k = 0; k < tile_size; ++k) r[k] = std::sqrt(a[k]);
    return 1.0f / r;
#endif
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
#if !defined(__AVX512F__)
namespace detail {
inline unsigned signBits(FloatPart a) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_ps(a));
#elif defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(a));
#else
    unsigned bits = 0;
    for (int k = 0; k < part_bytes / 4; ++k) bits |= std::signbit(a[k]) ? 1u << k : 0u;
    return bits;
#endif
}
inline unsigned signBits(DoublePart a) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_pd(a));
#elif defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_pd(a));
#else
    unsigned bits = 0;
    for (int k = 0; k < part_bytes / 8; ++k) bits |= std::signbit(a[k]) ? 1u << k : 0u;
    return bits;
#endif
}
template <class Part, class Vector>
[[gnu::always_inline]] inline unsigned lessBits(Vector a, Vector b) {
    const auto x = __builtin_bit_cast(Parts<Part>, a);
    const auto y = __builtin_bit_cast(Parts<Part>, b);
    constexpr int each = sizeof(Part) / sizeof(a[0]);
    unsigned bits = 0;
    for (int k = 0; k < Parts<Part>::count; ++k)
        bits |= signBits(reinterpret_cast<Part>(x.of[k] < y.of[k])) << (each * k);
    return bits;
}
}  // namespace detail
#endif

/// Bit k is set where a[k] < b[k].
inline unsigned lessBits(Lanes a, Lanes b) {
#if defined(__AVX512F__)
    return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b),
                              _CMP_LT_OQ);
#else
    return detail::lessBits<DoublePart>(a, b);
#endif
}
inline unsigned lessBits(FloatTile a, FloatTile b) {
#if defined(__AVX512F__)
    return _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), _CMP_LT_OQ);
#else
    return detail::lessBits<FloatPart>(a, b);
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

/// Three doubles of a record, and a zero.
inline HalfLanes loadThree(const double* p) {
#if defined(__AVX512VL__)
    return reinterpret_cast<HalfLanes>(_mm256_maskz_loadu_pd(0x7, p));
#else
    return HalfLanes{p[0], p[1], p[2], 0};
#endif
}

/// Numbers of which sums are exact, whatever the order: whole numbers, which are doubles where the
/// processor has no fast conversion to integers. Sums stay below 2^51; beyond they are as good as
/// plain ones there, but depend on the order. The whole numbers have a sign, but are added modulo
/// 2^64: where physics fails a sum may overflow before somebody notices.
#if defined(__AVX512DQ__)
using ExactNumber = std::uint64_t;
#else
using ExactNumber = double;
#endif
using ExactLanes = ExactNumber __attribute__((vector_size(64)));
using ExactQuad = ExactNumber __attribute__((vector_size(32)));

inline double fromExact(ExactNumber a) {
#if defined(__AVX512DQ__)
    return static_cast<double>(static_cast<std::int64_t>(a));
#else
    return a;
#endif
}
inline Lanes fromExact(ExactLanes a) {
#if defined(__AVX512DQ__)
    using Signed = std::int64_t __attribute__((vector_size(64)));
    return __builtin_convertvector(reinterpret_cast<Signed>(a), Lanes);
#else
    return a;
#endif
}

/// Rounded to whole numbers.
inline ExactLanes toExact(Lanes a) {
#if defined(__AVX512DQ__)
    return reinterpret_cast<ExactLanes>(
        _mm512_maskz_cvtpd_epi64(0xff, reinterpret_cast<__m512d>(a)));
#else
    constexpr double shift = 0x1.8p52;  // beside it a double has no fraction
    return (a + shift) - shift;
#endif
}
inline ExactLanes toExact(FloatLanes a) {
#if defined(__AVX512DQ__)
    return reinterpret_cast<ExactLanes>(
        _mm512_maskz_cvtps_epi64(0xff, reinterpret_cast<__m256>(a)));
#else
    return toExact(toLanes(a));
#endif
}

#if defined(__AVX512F__)
#define SPHINX_SPREADS_WORDS
/// Records of `Size` floats of four particles: out[c] has word c of particle at[four_of(i, j)] in
/// lane 4 i + j.
template <int Words, int Size, class FourOf>
[[gnu::always_inline]] inline void spreadWords(const float* records, const std::uint32_t* at,
                                               FloatTile (&out)[Size], FourOf four_of) {
    static_assert(Size == 4 || Size == 8);
    const auto row = [&](int k) { return records + std::size_t{Size} * at[k]; };
    const auto lanesOf = [&](int c) {
        WholeTile from = {};
        for (int i = 0; i < tile_side; ++i)
            for (int j = 0; j < tile_side; ++j) from[tile_side * i + j] = Size * four_of(i, j) + c;
        return reinterpret_cast<__m512i>(from);
    };
    if constexpr (Size == 4) {
        __m512 all = _mm512_castps128_ps512(_mm_loadu_ps(row(0)));
        all = _mm512_maskz_insertf32x4(0xffff, all, _mm_loadu_ps(row(1)), 1);
        all = _mm512_maskz_insertf32x4(0xffff, all, _mm_loadu_ps(row(2)), 2);
        all = _mm512_maskz_insertf32x4(0xffff, all, _mm_loadu_ps(row(3)), 3);
        for (int c = 0; c < Words; ++c)
            out[c] =
                reinterpret_cast<FloatTile>(_mm512_maskz_permutexvar_ps(0xffff, lanesOf(c), all));
    } else {
        const auto two = [&](int k) {
            const __m512d first =
                _mm512_castpd256_pd512(_mm256_loadu_pd(reinterpret_cast<const double*>(row(k))));
            return _mm512_castpd_ps(_mm512_maskz_insertf64x4(
                0xff, first, _mm256_loadu_pd(reinterpret_cast<const double*>(row(k + 1))), 1));
        };
        const __m512 a = two(0);
        const __m512 b = two(2);
        for (int c = 0; c < Words; ++c)
            out[c] = reinterpret_cast<FloatTile>(_mm512_permutex2var_ps(a, lanesOf(c), b));
    }
}
#elif defined(__SSE2__)
#define SPHINX_SPREADS_WORDS
namespace detail {
/// Lanes 4 i to 4 i + 3 are those of row i.
inline FloatTile joinRows(__m128 a, __m128 b, __m128 c, __m128 d) {
#if defined(__AVX__)
    const Parts<FloatPart> joined = {{reinterpret_cast<FloatPart>(_mm256_set_m128(b, a)),
                                      reinterpret_cast<FloatPart>(_mm256_set_m128(d, c))}};
#else
    const Parts<FloatPart> joined = {
        {reinterpret_cast<FloatPart>(a), reinterpret_cast<FloatPart>(b),
         reinterpret_cast<FloatPart>(c), reinterpret_cast<FloatPart>(d)}};
#endif
    return __builtin_bit_cast(FloatTile, joined);
}
template <int lane>
inline __m128 spreadLane(__m128 a) {
    return _mm_shuffle_ps(a, a, lane * 0x55);
}
}  // namespace detail

/// As above. (What GCC 12 makes of shuffles of plain vectors goes by registers of integers.)
template <int Words, int Size, class FourOf>
[[gnu::always_inline]] inline void spreadWords(const float* records, const std::uint32_t* at,
                                               FloatTile (&out)[Size], FourOf four_of) {
    for (int first = 0; first < Words; first += 4) {
        const auto row = [&](int k) {
            return _mm_loadu_ps(records + std::size_t{Size} * at[k] + first);
        };
        __m128 words[4] = {row(0), row(1), row(2), row(3)};
        _MM_TRANSPOSE4_PS(words[0], words[1], words[2], words[3]);
        for (int c = first; c < Words && c < first + 4; ++c) {
            const __m128 w = words[c - first];
            if (four_of(0, 1) == 1)
                out[c] = detail::joinRows(w, w, w, w);
            else
                out[c] = detail::joinRows(detail::spreadLane<0>(w), detail::spreadLane<1>(w),
                                          detail::spreadLane<2>(w), detail::spreadLane<3>(w));
        }
    }
}
#endif

/// Whether any of flags[at[0]] to flags[at[count - 1]] is not 0. Reads three bytes beyond a flag.
inline bool anyOf(const std::uint8_t* flags, const std::uint32_t* at, std::size_t count) {
#if defined(__AVX512F__)
    __m512i found = _mm512_setzero_si512();
    for (std::size_t first = 0; first < count; first += tile_size) {
        const std::size_t left = count - first;
        const auto some = static_cast<__mmask16>(left < tile_size ? (1u << left) - 1 : 0xffffu);
        found = _mm512_or_si512(found, _mm512_mask_i32gather_epi32(
                                           _mm512_setzero_si512(), some,
                                           _mm512_maskz_loadu_epi32(some, at + first), flags, 1));
    }
    return _mm512_test_epi32_mask(found, _mm512_set1_epi32(0xff)) != 0;
#else
    std::uint8_t found = 0;
    for (std::size_t k = 0; k < count; ++k) found |= flags[at[k]];
    return found != 0;
#endif
}
/// Writes first + k for each of the sixteen bits k that is set, ascending. May write sixteen
/// places.
inline void writePlaces(unsigned bits, std::uint32_t first, std::uint32_t* out) {
#if defined(__AVX512F__)
    const __m512i places =
        _mm512_add_epi32(_mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15),
                         _mm512_set1_epi32(static_cast<int>(first)));
    _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), places));
#else
    for (; bits != 0; bits &= bits - 1)
        *out++ = first + static_cast<std::uint32_t>(__builtin_ctz(bits));
#endif
}

}  // namespace sphinx
