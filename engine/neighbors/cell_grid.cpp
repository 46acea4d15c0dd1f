// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/cell_grid.h"

#include "core/errors.h"
#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sphinx::neighbors {

template <int Dim>
void CellGrid<Dim>::build(const Vec<Dim>* position, std::size_t n, double cell_size) {
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
    const Box<Dim>& bounds = extent.box;
    order_.resize(n);
    cell_of_.resize(n);
    if (n == 0) {
        start_.assign(1, 0);
        counts_.fill(0);
        return;
    }

    // A body that spreads far (spray) must not make more cells than a few per particle.
    size_ = cell_size;
    const double limit = std::min(64.0 * static_cast<double>(n) + 4096,
                                  static_cast<double>(std::numeric_limits<Index>::max()));
    for (;;) {
        double cells = 1;
        for (int k = 0; k < Dim; ++k) cells *= std::floor(bounds.size()[k] / size_) + 1;
        if (cells <= limit) break;
        size_ *= 1.25;
    }
    origin_ = bounds.lower;
    std::size_t cells = 1;
    for (int k = 0; k < Dim; ++k) {
        counts_[k] = static_cast<int>(bounds.size()[k] / size_) + 1;
        cells *= static_cast<std::size_t>(counts_[k]);
    }

    const double inverse = 1 / size_;
    parallelRanges(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::size_t cell = 0;
            for (int k = Dim - 1; k >= 0; --k) {
                const int c = std::min(static_cast<int>((position[i][k] - origin_[k]) * inverse),
                                       counts_[k] - 1);
                cell = cell * static_cast<std::size_t>(counts_[k]) + static_cast<std::size_t>(c);
            }
            cell_of_[i] = static_cast<Index>(cell);
        }
    });

    // Counting sort. Serial: its two passes cost less than one pair sum and keep storage order.
    start_.assign(cells + 1, 0);
    for (std::size_t i = 0; i < n; ++i) ++start_[cell_of_[i] + 1];
    for (std::size_t c = 0; c < cells; ++c) start_[c + 1] += start_[c];
    for (std::size_t i = 0; i < n; ++i) order_[start_[cell_of_[i]]++] = static_cast<Index>(i);
    for (std::size_t c = cells; c > 0; --c) start_[c] = start_[c - 1];
    start_[0] = 0;

    sites_.resize(n);
    parallelFor(n, [&](std::size_t s) {
        const Vec<Dim>& x = position[order_[s]];
        sites_[s] = {{x[0], x[1], Dim == 3 ? x[Dim - 1] : 0}, static_cast<double>(order_[s])};
    });
}

template <int Dim>
std::array<int, Dim> CellGrid<Dim>::cellCoordinates(std::size_t cell) const {
    std::array<int, Dim> c{};
    for (int k = 0; k < Dim; ++k) {
        c[k] = static_cast<int>(cell % static_cast<std::size_t>(counts_[k]));
        cell /= static_cast<std::size_t>(counts_[k]);
    }
    return c;
}

template <int Dim>
std::size_t CellGrid<Dim>::cellIndex(const std::array<int, Dim>& c) const {
    std::size_t cell = 0;
    for (int k = Dim - 1; k >= 0; --k)
        cell = cell * static_cast<std::size_t>(counts_[k]) + static_cast<std::size_t>(c[k]);
    return cell;
}

template <int Dim>
std::size_t CellGrid<Dim>::bytes() const {
    return 4 * (start_.capacity() + cell_of_.capacity() + order_.capacity()) +
           sizeof(Site) * sites_.capacity();
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace sphinx::neighbors
