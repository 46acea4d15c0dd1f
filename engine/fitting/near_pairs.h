// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"
#include "neighbors/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sphinx::fitting {

/// Calls use(particle) for those in the cell of a point and the cells next to it.
template <int Dim, class Use>
void forEachAround(const neighbors::CellGrid<Dim>& grid, const Vec<Dim>& x, Use&& use) {
    std::array<int, Dim> first{}, last{};
    for (int k = 0; k < Dim; ++k) {
        const auto at = static_cast<int>(std::floor((x[k] - grid.origin()[k]) / grid.cellSize()));
        first[k] = std::clamp(at - 1, 0, grid.counts()[k] - 1);
        last[k] = std::clamp(at + 1, 0, grid.counts()[k] - 1);
    }
    std::array<int, Dim> cell = first;
    for (int k = 0; k < Dim;) {
        const std::size_t c = grid.cellIndex(cell);
        for (std::size_t s = grid.start(c); s < grid.start(c + 1); ++s) use(grid.order()[s]);
        for (k = 0; k < Dim; ++k) {
            if (++cell[k] <= last[k]) break;
            cell[k] = first[k];
        }
    }
}

/// The neighbors of point i are neighbor[first[i]] to neighbor[first[i + 1] - 1].
struct NearPairs {
    std::vector<std::size_t> first;
    std::vector<Index> neighbor;
};

/// Points nearer to each other than that.
template <int Dim>
NearPairs nearPairs(const AlignedVector<Vec<Dim>>& position, double nearer);

}  // namespace sphinx::fitting
