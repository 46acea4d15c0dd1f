// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/columns.h"

#include "core/errors.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sphinx::neighbors {

template <int Dim>
Box<Dim> boundsOf(const Vec<Dim>* position, std::size_t n) {
    struct Extent {
        Box<Dim> box;
        double zero = 0;  // unless a position is not finite
    };
    const Extent extent = reduceLocal(
        n, Extent{},
        [&](std::size_t begin, std::size_t end) {
            Extent e;
            for (std::size_t i = begin; i < end; ++i) {
                e.box.include(position[i]);
                e.zero += 0 * position[i].sum();
            }
            return e;
        },
        [](Extent a, const Extent& b) {
            a.box.include(b.box);
            a.zero += b.zero;
            return a;
        });
    if (extent.zero != 0) throw PhysicsError("the position of a particle is not a finite number");
    return extent.box;
}

template <int Dim>
void Columns<Dim>::build(const Vec<Dim>* points, std::size_t n, const Box<Dim>& bounds,
                         const Vec<Dim>& frame, double spacing, double cutoff) {
    slots_ = 0;
    order_.resize(n);
    bin_of_.resize(n);
    counts_.fill(0);
    if (n == 0) {
        start_.assign(1, 0);
        return;
    }
    // Points that spread far (spray) must not make more bins than a few for each.
    double width = std::pow(tile_side, 1.0 / Dim) * spacing;
    double bin = 0.5 * spacing;
    const double limit = std::min(3.0 * static_cast<double>(n) + 4096,
                                  static_cast<double>(std::numeric_limits<Index>::max()));
    const Vec<Dim> size = bounds.size();
    for (bool longer = true;; longer = !longer) {
        double bins = std::floor(size[0] / bin) + 1;
        for (int k = 1; k < Dim; ++k) bins *= std::floor(size[k] / width) + 1;
        if (bins <= limit) break;
        (longer && bin < width ? bin : width) *= 1.25;
        bin = std::max(bin, 0.25 * width);
    }
    std::size_t bins = 1;
    for (int k = 0; k < Dim; ++k) {
        counts_[k] = static_cast<int>(size[k] / (k == 0 ? bin : width)) + 1;
        bins *= static_cast<std::size_t>(counts_[k]);
        offset_[k] = static_cast<float>((bounds.lower[k] - frame[k]) / cutoff);
    }
    width_ = static_cast<float>(width / cutoff);
    bin_ = static_cast<float>(bin / cutoff);

    start_.assign(bins + 2, 0);
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t at = 0;
        for (int k = Dim - 1; k >= 0; --k) {
            const double c = (points[i][k] - bounds.lower[k]) / (k == 0 ? bin : width);
            at = at * static_cast<std::size_t>(counts_[k]) +
                 static_cast<std::size_t>(std::min(static_cast<int>(c), counts_[k] - 1));
        }
        bin_of_[i] = static_cast<Index>(at);
        ++start_[at + 2];
    }
    // Until all points are placed, entry b + 1 is where the next one of bin b goes.
    for (std::size_t b = 1; b <= bins; ++b) start_[b + 1] += start_[b];
    for (std::size_t i = 0; i < n; ++i) order_[start_[bin_of_[i] + 1]++] = static_cast<Index>(i);

    // Positions of pairs are told apart within four cutoffs (PairTiles).
    constexpr float longest = 1.25f;
    const auto columns = bins / static_cast<std::size_t>(counts_[0]);
    const auto reserve = [&](std::size_t slots) {
        if (point_.size() >= slots + 2 * tile_size) return;
        point_.resize(slots + slots / 8 + 2 * tile_size);
        column_of_.resize(point_.size() / tile_side + 1);
        for (auto& x : x_) x.resize(point_.size());
    };
    const auto fillUp = [&] {
        for (; slots_ % tile_side != 0; ++slots_) {
            point_[slots_] = none;
            for (auto& x : x_) x[slots_] = far_away;
        }
    };
    reserve(n + n / 8);
    std::size_t b = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        for (int in_column = 0; in_column < counts_[0]; ++in_column, ++b) {
            const std::uint32_t begin = start_[b];
            const std::uint32_t end = start_[b + 1];
            for (std::uint32_t m = begin; m < end; ++m) {
                reserve(slots_ + tile_side);
                const Vec<Dim> x = (points[order_[m]] - frame) / cutoff;
                const Index first = slots_ / tile_side * tile_side;
                if (slots_ != first) {
                    bool near = true;
                    for (int k = 0; k < Dim; ++k)
                        near &= std::abs(static_cast<float>(x[k]) - x_[k][first]) < longest;
                    if (!near) fillUp();
                }
                if (m == begin) start_[b] = slots_;
                column_of_[slots_ / tile_side] = static_cast<std::uint32_t>(column);
                point_[slots_] = order_[m];
                for (int k = 0; k < Dim; ++k) x_[k][slots_] = static_cast<float>(x[k]);
                ++slots_;
            }
            if (begin == end) start_[b] = slots_;
        }
        fillUp();
    }
    start_[bins] = slots_;
    // The search reads sixteen at a time.
    reserve(slots_);
    for (Index s = slots_; s < slots_ + tile_size; ++s)
        for (auto& x : x_) x[s] = far_away;
}

template <int Dim>
std::size_t Columns<Dim>::bytes() const {
    return 4 * (start_.capacity() + bin_of_.capacity() + order_.capacity() + point_.capacity() +
                column_of_.capacity() + Dim * x_[0].capacity());
}

template Box<2> boundsOf(const Vec<2>*, std::size_t);
template Box<3> boundsOf(const Vec<3>*, std::size_t);
template class Columns<2>;
template class Columns<3>;

}  // namespace sphinx::neighbors
