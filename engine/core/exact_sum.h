// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/lanes.h"

#include <utility>

namespace sphinx {

/// Grid that the terms of an ExactSum are rounded to. `bound`: of the sum and of its parts,
/// positive; the grid is 4.5e-16 of it or finer.
class SumGrid {
 public:
    explicit SumGrid(double bound) : offset_(3 * std::exp2(std::ceil(std::log2(bound)))) {}
    /// Numbers near it are whole multiples of the grid.
    double offset() const { return offset_; }

 private:
    double offset_;
};

/// Sums terms, eight at a time, that are rounded to a grid so coarse that nothing more is lost when
/// they are added: the order of the terms makes no difference to any bit. Of mirrored particles it
/// is the mirrored sum, wherever the neighbors stand in the lists. Costs nothing over a plain sum
/// of products. Sums beyond the grid's bound are as good as plain ones, but depend on the order.
///
/// The sum starts from the grid's offset, so every addition rounds its term to the grid. A product
/// is added with one rounding: rounded before, it could stand halfway between two points of the
/// grid, and then which one it goes to would depend on the sum so far.
class ExactSum {
 public:
    explicit ExactSum(const SumGrid& grid) : offset_(lanes(grid.offset())), sum_(offset_) {}

    void add(Lanes term) { sum_ += (term + offset_) - offset_; }
    void addProduct(Lanes a, Lanes b) {
#if defined(SPHINX_HAS_FUSED)
        sum_ = fused(a, b, sum_);
#else
        add(a * b);
#endif
    }
    double value() const { return sumLanes(sum_ - offset_); }

 private:
    Lanes offset_;
    Lanes sum_;
};

/// One for each component of a vector.
template <int Dim>
class ExactSums {
 public:
    explicit ExactSums(const SumGrid& grid) : ExactSums(grid, std::make_index_sequence<Dim>()) {}
    ExactSum& operator[](int component) { return sums_[component]; }

 private:
    template <std::size_t... component>
    ExactSums(const SumGrid& grid, std::index_sequence<component...>)
        : sums_{((void)component, ExactSum(grid))...} {}

    ExactSum sums_[Dim];
};

}  // namespace sphinx
