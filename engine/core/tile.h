// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

// A tile holds the pairs of four particles i with four particles j as one vector of sixteen
// numbers, floats or doubles: the pair of i and j stands in lane 4 i + j. All that needs to know
// so, or the instruction set, is in this file.
namespace sphinx {

inline constexpr int tile_side = 4;
inline constexpr int tile_size = tile_side * tile_side;

using WholeTile = std::int32_t __attribute__((vector_size(64)));
/// Sixteen numbers of a precision, float or double.
template <class Real>
using TileOf = std::conditional_t<std::is_same_v<Real, float>, FloatTile, DoubleTile>;
/// One number of each of four particles.
using FloatQuad = float __attribute__((vector_size(16)));
using DoubleQuad = double __attribute__((vector_size(32)));
template <class Real>
using QuadOf = std::conditional_t<std::is_same_v<Real, float>, FloatQuad, DoubleQuad>;

inline FloatTile loadTile(const float* p) {
    FloatTile a;
    std::memcpy(&a, p, sizeof a);
    return a;
}
inline DoubleTile loadTile(const double* p) { return {loadLanes(p), loadLanes(p + lane_count)}; }
inline void storeTile(FloatTile a, float* p) { std::memcpy(p, &a, sizeof a); }
inline void storeTile(const DoubleTile& a, double* p) {
    storeLanes(a.low, p);
    storeLanes(a.high, p + lane_count);
}

inline FloatTile toFloat(WholeTile a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_cvtepi32_ps(0xffff, reinterpret_cast<__m512i>(a)));
#else
    return __builtin_convertvector(a, FloatTile);
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

inline DoubleTile inverseSqrtTile(const DoubleTile& a) {
    return {inverseSqrtLanes(a.low), inverseSqrtLanes(a.high)};
}

/// a of each j in the lanes of its pairs.
inline DoubleTile ofEachJ(DoubleQuad a) {
    const Lanes half = __builtin_shufflevector(a, a, 0, 1, 2, 3, 0, 1, 2, 3);
    return {half, half};
}
inline FloatTile ofEachJ(FloatQuad a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(
        _mm512_maskz_broadcast_f32x4(0xffff, reinterpret_cast<__m128>(a)));
#else
    return __builtin_shufflevector(a, a, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
#endif
}
/// a of each i in the lanes of its pairs.
inline DoubleTile ofEachI(DoubleQuad a) {
    return {__builtin_shufflevector(a, a, 0, 0, 0, 0, 1, 1, 1, 1),
            __builtin_shufflevector(a, a, 2, 2, 2, 2, 3, 3, 3, 3)};
}
inline FloatTile ofEachI(FloatQuad a) {
#if defined(__AVX512F__)
    return reinterpret_cast<FloatTile>(_mm512_maskz_permutexvar_ps(
        0xffff, _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3),
        _mm512_castps128_ps512(reinterpret_cast<__m128>(a))));
#else
    return __builtin_shufflevector(a, a, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
#endif
}

namespace detail {
/// The first `Words` words (an even number) of records of `Size` of the four particles at[0] to
/// at[3], transposed: out[c] is word c of all four.
template <int Words, class Real, int Size>
[[gnu::always_inline]] inline void transposeWords(const Real* records, const std::uint32_t* at,
                                                  QuadOf<Real> (&out)[Size]) {
    using Quad = QuadOf<Real>;
    const auto four = [&](int k, int first) {
        Quad a;
        std::memcpy(&a, records + std::size_t{Size} * at[k] + first, sizeof a);
        return a;
    };
    for (int first = 0; first < Words; first += 4) {
        const Quad a = four(0, first);
        const Quad b = four(1, first);
        const Quad c = four(2, first);
        const Quad d = four(3, first);
        const Quad ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const Quad cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        out[first] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
        out[first + 1] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
        if (first + 2 >= Words) continue;
        const Quad AB = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Quad CD = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        out[first + 2] = __builtin_shufflevector(AB, CD, 0, 1, 4, 5);
        out[first + 3] = __builtin_shufflevector(AB, CD, 2, 3, 6, 7);
    }
}
#if defined(__AVX512F__)
/// The same of floats, word c in the lanes lane_of(i, j), which is 0 to 3 of the records.
template <int Words, int Size, class LaneOf>
[[gnu::always_inline]] inline void spreadWords(const float* records, const std::uint32_t* at,
                                               FloatTile (&out)[Size], LaneOf lane_of) {
    static_assert(Size == 4 || Size == 8);
    const auto row = [&](int k) { return records + std::size_t{Size} * at[k]; };
    const auto lanesOf = [&](int c) {
        WholeTile from = {};
        for (int i = 0; i < tile_side; ++i)
            for (int j = 0; j < tile_side; ++j) from[tile_side * i + j] = Size * lane_of(i, j) + c;
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
#endif
}  // namespace detail

/// Records of `Size` numbers of the four particles at[0] to at[3]: out[c] is word c, of the first
/// `Words` (an even number), of each j or of each i in the lanes of its pairs.
template <int Words, class Real, int Size>
[[gnu::always_inline]] inline void gatherOfEachJ(const Real* records, const std::uint32_t* at,
                                                 TileOf<Real> (&out)[Size]) {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<Real, float>)
        return detail::spreadWords<Words>(records, at, out, [](int, int j) { return j; });
#endif
    QuadOf<Real> quads[Size];
    detail::transposeWords<Words>(records, at, quads);
    for (int c = 0; c < Words; ++c) out[c] = ofEachJ(quads[c]);
}
template <int Words, class Real, int Size>
[[gnu::always_inline]] inline void gatherOfEachI(const Real* records, const std::uint32_t* at,
                                                 TileOf<Real> (&out)[Size]) {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<Real, float>)
        return detail::spreadWords<Words>(records, at, out, [](int i, int) { return i; });
#endif
    QuadOf<Real> quads[Size];
    detail::transposeWords<Words>(records, at, quads);
    for (int c = 0; c < Words; ++c) out[c] = ofEachI(quads[c]);
}

/// Sixteen numbers as two halves of doubles.
inline Lanes lowLanes(WholeTile a) {
    const auto h = __builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7);
#if defined(__AVX512F__)
    return reinterpret_cast<Lanes>(_mm512_maskz_cvtepi32_pd(0xff, reinterpret_cast<__m256i>(h)));
#else
    return __builtin_convertvector(h, Lanes);
#endif
}
inline Lanes highLanes(WholeTile a) {
    return lowLanes(
        __builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
}
inline Lanes lowLanes(FloatTile a) {
    return toLanes(__builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7));
}
inline Lanes highLanes(FloatTile a) {
    return toLanes(__builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15));
}
inline FloatTile joinFloats(Lanes low, Lanes high) {
    return __builtin_shufflevector(toFloat(low), toFloat(high), 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
                                   11, 12, 13, 14, 15);
}

/// Numbers of which sums are exact, whatever the order: whole numbers, which are doubles where the
/// processor has no fast conversion to integers. Sums stay below 2^51; beyond they are as good as
/// plain ones there, but depend on the order.
#if defined(__AVX512DQ__)
using ExactNumber = std::int64_t;
#else
using ExactNumber = double;
#endif
using ExactLanes = ExactNumber __attribute__((vector_size(64)));
using ExactQuad = ExactNumber __attribute__((vector_size(32)));

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

/// The terms of sixteen pairs, or sums of such.
struct ExactTile {
    ExactLanes low = {};   // of the first two i
    ExactLanes high = {};  // of the others

    ExactTile() = default;
    ExactTile(Lanes a, Lanes b) : low(toExact(a)), high(toExact(b)) {}
    explicit ExactTile(const DoubleTile& a) : ExactTile(a.low, a.high) {}
    explicit ExactTile(FloatTile a) {
        const FloatLanes l = __builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7);
        const FloatLanes h = __builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15);
#if defined(__AVX512DQ__)
        low = reinterpret_cast<ExactLanes>(
            _mm512_maskz_cvtps_epi64(0xff, reinterpret_cast<__m256>(l)));
        high = reinterpret_cast<ExactLanes>(
            _mm512_maskz_cvtps_epi64(0xff, reinterpret_cast<__m256>(h)));
#else
        low = toExact(toLanes(l));
        high = toExact(toLanes(h));
#endif
    }
    void operator+=(const ExactTile& b) {
        low += b.low;
        high += b.high;
    }
};

namespace detail {
/// Sum over two neighboring lanes of a, then of b, by turns.
inline ExactLanes pairwise(ExactLanes a, ExactLanes b) {
    return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
           __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
/// Sums over j of a and b, for i one after the other.
inline ExactLanes overJ(const ExactTile& a, const ExactTile& b) {
    const ExactLanes low = pairwise(a.low, b.low);
    const ExactLanes high = pairwise(a.high, b.high);
    return __builtin_shufflevector(low, high, 0, 1, 4, 5, 8, 9, 12, 13) +
           __builtin_shufflevector(low, high, 2, 3, 6, 7, 10, 11, 14, 15);
}
template <class Vector, int Sign = 1>
inline void addTo(ExactNumber* p, Vector a) {
    Vector b;
    std::memcpy(&b, p, sizeof b);
    b = Sign > 0 ? b + a : b - a;
    std::memcpy(p, &b, sizeof b);
}
}  // namespace detail

/// How many numbers stand together for `N` sums of a particle.
template <int N>
inline constexpr int sum_stride = N == 3 ? 4 : N;

/// Adds the sums over j to those of the four particles i, which stand one after the other.
template <int N>
[[gnu::always_inline]] inline void addOverJ(const ExactTile (&sum)[N], ExactNumber* sums) {
    static_assert(N >= 1 && N <= 3);
    if constexpr (N == 1) {
        const ExactLanes s = detail::overJ(sum[0], sum[0]);
        detail::addTo<ExactQuad>(sums, __builtin_shufflevector(s, s, 0, 2, 4, 6));
    } else {
        const ExactLanes xy = detail::overJ(sum[0], sum[1]);
        if constexpr (N == 2) {
            detail::addTo(sums, xy);
        } else {
            const ExactLanes z = detail::overJ(sum[2], ExactTile());
            detail::addTo(sums, __builtin_shufflevector(xy, z, 0, 1, 8, 9, 2, 3, 10, 11));
            detail::addTo(sums + 8, __builtin_shufflevector(xy, z, 4, 5, 12, 13, 6, 7, 14, 15));
        }
    }
}

/// Adds (Sign 1) or subtracts (-1) the sums over i to those of the four particles j, which stand
/// anywhere.
template <int N, int Sign>
[[gnu::always_inline]] inline void addOverI(const ExactTile (&term)[N], const std::uint32_t* j,
                                            ExactNumber* sums) {
    static_assert(N >= 1 && N <= 3);
    const auto overI = [](const ExactTile& a) -> ExactQuad {
        const ExactLanes s = a.low + a.high;
        return __builtin_shufflevector(s, s, 0, 1, 2, 3) +
               __builtin_shufflevector(s, s, 4, 5, 6, 7);
    };
    const auto at = [&](int k) { return sums + std::size_t{sum_stride<N>} * j[k]; };
    const ExactQuad x = overI(term[0]);
    if constexpr (N == 1) {
        for (int k = 0; k < tile_side; ++k) *at(k) += Sign * x[k];
    } else {
        using Pair = ExactNumber __attribute__((vector_size(16)));
        const ExactQuad y = overI(term[1]);
        const ExactQuad even = __builtin_shufflevector(x, y, 0, 4, 2, 6);
        const ExactQuad odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
        if constexpr (N == 2) {
            const auto half = [](ExactQuad a, auto upper) -> Pair {
                if constexpr (upper)
                    return __builtin_shufflevector(a, a, 2, 3);
                else
                    return __builtin_shufflevector(a, a, 0, 1);
            };
            detail::addTo<Pair, Sign>(at(0), half(even, std::false_type()));
            detail::addTo<Pair, Sign>(at(1), half(odd, std::false_type()));
            detail::addTo<Pair, Sign>(at(2), half(even, std::true_type()));
            detail::addTo<Pair, Sign>(at(3), half(odd, std::true_type()));
        } else {
            const ExactQuad z = overI(term[2]);
            const ExactQuad none = {};
            const ExactQuad even_z = __builtin_shufflevector(z, none, 0, 4, 2, 6);
            const ExactQuad odd_z = __builtin_shufflevector(z, none, 1, 5, 3, 7);
            detail::addTo<ExactQuad, Sign>(at(0),
                                           __builtin_shufflevector(even, even_z, 0, 1, 4, 5));
            detail::addTo<ExactQuad, Sign>(at(1), __builtin_shufflevector(odd, odd_z, 0, 1, 4, 5));
            detail::addTo<ExactQuad, Sign>(at(2),
                                           __builtin_shufflevector(even, even_z, 2, 3, 6, 7));
            detail::addTo<ExactQuad, Sign>(at(3), __builtin_shufflevector(odd, odd_z, 2, 3, 6, 7));
        }
    }
}

/// Bit k is set where a[k] < b[k].
inline unsigned lessBits(const DoubleTile& a, const DoubleTile& b) {
    return lessBits(a.low, b.low) | lessBits(a.high, b.high) << lane_count;
}
inline unsigned lessBits(FloatTile a, FloatTile b) {
#if defined(__AVX512F__)
    return _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), _CMP_LT_OQ);
#else
    const WholeTile less = a < b;
    unsigned bits = 0;
    for (int k = 0; k < tile_size; ++k) bits |= less[k] ? 1u << k : 0u;
    return bits;
#endif
}
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
