// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

// A tile holds the pairs of four particles i with four particles j as one vector of sixteen
// numbers, floats or doubles: the pair of i and j stands in lane 4 i + j. All that needs to know
// so is in this file; what the processor has for it, in core/processor.h.
namespace sphinx {

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

inline DoubleTile inverseSqrtTile(const DoubleTile& a) {
    return {inverseSqrtLanes(a.low), inverseSqrtLanes(a.high)};
}

/// a of each j in the lanes of its pairs.
inline DoubleTile ofEachJ(DoubleQuad a) {
    const Lanes half = __builtin_shufflevector(a, a, 0, 1, 2, 3, 0, 1, 2, 3);
    return {half, half};
}
inline FloatTile ofEachJ(FloatQuad a) {
    return __builtin_shufflevector(a, a, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3);
}
/// a of each i in the lanes of its pairs.
inline DoubleTile ofEachI(DoubleQuad a) {
    return {__builtin_shufflevector(a, a, 0, 0, 0, 0, 1, 1, 1, 1),
            __builtin_shufflevector(a, a, 2, 2, 2, 2, 3, 3, 3, 3)};
}
inline FloatTile ofEachI(FloatQuad a) {
    return __builtin_shufflevector(a, a, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
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
}  // namespace detail

/// Whose number stands in the lane of a pair.
enum class Of { i, j };

/// Records of `Size` numbers of the four particles at[0] to at[3]: out[c] is word c, of the first
/// `Words` (an even number), of each i or j in the lanes of its pairs.
template <Of side, int Words, class Real, int Size>
[[gnu::always_inline]] inline void gatherOfEach(const Real* records, const std::uint32_t* at,
                                                TileOf<Real> (&out)[Size]) {
#if defined(SPHINX_SPREADS_WORDS)
    if constexpr (std::is_same_v<Real, float>)
        return spreadWords<Words>(records, at, out,
                                  [](int i, int j) { return side == Of::i ? i : j; });
#endif
    QuadOf<Real> quads[Size];
    detail::transposeWords<Words>(records, at, quads);
    for (int c = 0; c < Words; ++c) out[c] = side == Of::i ? ofEachI(quads[c]) : ofEachJ(quads[c]);
}

/// a - b modulo 2^32. (Of signed numbers an overflow has no meaning.)
inline WholeTile wrappedDifference(WholeTile a, WholeTile b) {
    using Wrapping = std::uint32_t __attribute__((vector_size(64)));
    return reinterpret_cast<WholeTile>(reinterpret_cast<Wrapping>(a) -
                                       reinterpret_cast<Wrapping>(b));
}

/// Sixteen numbers as two halves of doubles.
inline Lanes lowLanes(WholeTile a) {
    return toLanes(__builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7));
}
inline Lanes highLanes(WholeTile a) {
    return toLanes(__builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15));
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

/// The terms of sixteen pairs, or sums of such.
struct ExactTile {
    ExactLanes low = {};   // of the first two i
    ExactLanes high = {};  // of the others

    ExactTile() = default;
    ExactTile(Lanes a, Lanes b) : low(toExact(a)), high(toExact(b)) {}
    explicit ExactTile(const DoubleTile& a) : ExactTile(a.low, a.high) {}
    explicit ExactTile(FloatTile a)
        : low(toExact(__builtin_shufflevector(a, a, 0, 1, 2, 3, 4, 5, 6, 7))),
          high(toExact(__builtin_shufflevector(a, a, 8, 9, 10, 11, 12, 13, 14, 15))) {}
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

}  // namespace sphinx
