// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exact_total.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>

namespace sphinx {
namespace detail {

/// A number, or a vector or array of them.
template <class T>
struct Summand {
    static constexpr int size = static_cast<int>(sizeof(T) / sizeof(double));
    static double of(const T& term, int k) { return term[k]; }
    static void set(T& sum, int k, double value) { sum[k] = value; }
};
template <>
struct Summand<double> {
    static constexpr int size = 1;
    static double of(double term, int) { return term; }
    static void set(double& sum, int, double value) { sum = value; }
};

/// Filled up to whole lanes.
constexpr std::size_t padded(std::size_t n) {
    return (n + lane_count - 1) / lane_count * lane_count;
}

}  // namespace detail

/// Sum of value(i) over the particles of the run: a double, Vec<Dim> or std::array of doubles, each
/// component correctly rounded (ExactTotal). Its bits depend neither on the order of the particles
/// in memory nor on the threads. value(i) may write what belongs to particle i.
template <class Value>
auto sumAll(std::size_t n, Value&& value) {
    using T = std::decay_t<decltype(value(std::size_t{0}))>;
    using Term = detail::Summand<T>;
    using Totals = std::array<ExactTotal, Term::size>;
    constexpr std::size_t batch = ExactTotal::batch;
    const Totals totals = reduceAll(
        n, Totals{},
        [&](std::size_t begin, std::size_t end) {
            double terms[Term::size][batch];
            const std::size_t count = end - begin;
            for (std::size_t n = 0; n < count; ++n) {
                const T term = value(begin + n);
                for (int k = 0; k < Term::size; ++k) terms[k][n] = Term::of(term, k);
            }
            Totals sum{};
            for (int k = 0; k < Term::size; ++k) {
                std::fill(terms[k] + count, terms[k] + detail::padded(count), 0.0);
                sum[k].addBatch(terms[k], count);
            }
            return sum;
        },
        [](Totals a, const Totals& b) {
            for (int k = 0; k < Term::size; ++k) a[k] += b[k];
            return a;
        },
        batch);
    T sum;
    for (int k = 0; k < Term::size; ++k) Term::set(sum, k, totals[k].value());
    return sum;
}

}  // namespace sphinx
