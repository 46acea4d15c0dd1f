// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/processor.h"

namespace sphinx {

inline Lanes loadLanes(const double* p) {
    Lanes a;
    std::memcpy(&a, p, sizeof a);
    return a;
}

inline Lanes loadLanes(const std::int32_t* p) {
    WholeLanes a;
    std::memcpy(&a, p, sizeof a);
    return toLanes(a);
}
inline void storeLanes(Lanes a, double* p) { std::memcpy(p, &a, sizeof a); }
inline void storeLanes(Lanes a, std::int32_t* p) {
    const WholeLanes b = toWhole(a);
    std::memcpy(p, &b, sizeof b);
}

inline Lanes maxLanes(Lanes a, Lanes b) {
    return byParts<DoublePart>(a, b, [](DoublePart x, DoublePart y) { return x > y ? x : y; });
}
inline Lanes minLanes(Lanes a, Lanes b) {
    return byParts<DoublePart>(a, b, [](DoublePart x, DoublePart y) { return x < y ? x : y; });
}

/// The same in doubles: the first two of the four, and the others. (Of one vector of sixteen
/// doubles GCC 12 makes single numbers.)
struct DoubleTile {
    Lanes low = {}, high = {};

    double operator[](int k) const { return k < lane_count ? low[k] : high[k - lane_count]; }
    DoubleTile operator-() const { return {-low, -high}; }
    DoubleTile& operator+=(const DoubleTile& b) { return *this = *this + b; }
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

/// maskBits() where a comparison is true in every lane.
inline constexpr unsigned all_lanes = 0xff;

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

namespace detail {
/// The rows row(0) to row(7), transposed: out[c][k] is number c of row k.
template <int Numbers, class Row>
[[gnu::always_inline]] inline void transposeRows(Row&& row, Lanes out[Numbers]) {
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
    if constexpr (Numbers == 4) out[3] = __builtin_shufflevector(c, d, 4, 5, 6, 7, 12, 13, 14, 15);
}
}  // namespace detail

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
    detail::transposeRows<4>(row, out);
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

/// Records of three doubles, in the same way.
[[gnu::always_inline]] inline void gatherTriples(const double* base, const std::uint32_t* index,
                                                 Lanes out[3]) {
    const auto row = [&](int k) { return loadThree(base + std::size_t{3} * index[k]); };
    detail::transposeRows<3>(row, out);
}

}  // namespace sphinx
