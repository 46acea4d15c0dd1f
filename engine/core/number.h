// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

#include <cmath>
#include <type_traits>

// What pair terms ask of a number, which is double, eight of them (Lanes), or sixteen floats or
// doubles (FloatTile, DoubleTile).
namespace sphinx {

template <class Number>
inline constexpr bool is_tile =
    std::is_same_v<Number, FloatTile> || std::is_same_v<Number, DoubleTile>;

/// The number of which `Number` holds one or more.
template <class Number>
using ScalarOf =
    std::conditional_t<std::is_arithmetic_v<Number>, Number,
                       std::conditional_t<std::is_same_v<Number, FloatTile>, float, double>>;

/// The same value in each lane.
template <class Number>
[[gnu::always_inline]] inline Number everywhere(double a) {
    const auto value = static_cast<ScalarOf<Number>>(a);
    if constexpr (std::is_arithmetic_v<Number>)
        return value;
    else if constexpr (std::is_same_v<Number, FloatTile>)
        return tile(value);
    else if constexpr (is_tile<Number>)
        return Number{lanes(value), lanes(value)};
    else
        return Number{value, value, value, value, value, value, value, value};
}

template <class Number>
[[gnu::always_inline]] inline Number larger(Number a, Number b) {
    if constexpr (std::is_same_v<Number, FloatTile>)
        return maxTile(a, b);
    else if constexpr (is_tile<Number>)
        return {maxLanes(a.low, b.low), maxLanes(a.high, b.high)};
    else
        return a > b ? a : b;
}
template <class Number>
[[gnu::always_inline]] inline Number smaller(Number a, Number b) {
    if constexpr (std::is_same_v<Number, FloatTile>)
        return minTile(a, b);
    else if constexpr (is_tile<Number>)
        return {minLanes(a.low, b.low), minLanes(a.high, b.high)};
    else
        return a < b ? a : b;
}
/// 1 where a > 0, elsewhere -1.
template <class Number>
[[gnu::always_inline]] inline Number signOf(Number a) {
    if constexpr (std::is_same_v<Number, DoubleTile>)
        return {signOf<Lanes>(a.low), signOf<Lanes>(a.high)};
    else
        return a > Number{} ? everywhere<Number>(1) : everywhere<Number>(-1);
}
template <class Number>
[[gnu::always_inline]] inline Number absolute(Number a) {
    return larger<Number>(a, -a);
}

/// Sum over the components of a_c b_c. Every product is rounded before it is added: of a product
/// fused with the addition and one that is not, the components of a turned case would change
/// places. (Tiles are for files that fuse nothing: of a tile GCC 12 makes sixteen numbers behind
/// its barrier.)
template <int Dim, class Number>
[[gnu::always_inline]] inline Number dot(const Number* a, const Number* b) {
    const auto product = [&](int c) {
#if defined(__GNUC__) && !defined(__clang__)
        if constexpr (!is_tile<Number>)
            return __builtin_assoc_barrier(a[c] * b[c]);  // GCC fuses across statements
        else
#endif
            return a[c] * b[c];
    };
    Number sum = product(0);
    for (int c = 1; c < Dim; ++c) sum += product(c);
    return sum;
}

}  // namespace sphinx
