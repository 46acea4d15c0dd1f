// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/crowded.h"

#include "neighbors/cell_grid.h"

#include <array>
#include <limits>

namespace sphinx::fitting {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();

template <int Dim>
struct Nearest {
    Index index = none;
    double squared = 0;
};

/// The nearest to point i within a cell's size.
template <int Dim>
Nearest<Dim> nearestOf(const neighbors::CellGrid<Dim>& grid,
                       const AlignedVector<Vec<Dim>>& position, std::size_t i, double nearer) {
    Nearest<Dim> best{none, nearer * nearer};
    std::array<int, Dim> first{}, last{};
    for (int k = 0; k < Dim; ++k) {
        const double at = (position[i][k] - grid.origin()[k]) / grid.cellSize();
        first[k] = std::max(static_cast<int>(at) - 1, 0);
        last[k] = std::min(static_cast<int>(at) + 1, grid.counts()[k] - 1);
    }
    std::array<int, Dim> cell = first;
    for (;;) {
        const std::size_t c = grid.cellIndex(cell);
        for (std::size_t s = grid.start(c); s < grid.start(c + 1); ++s) {
            const Index j = grid.order()[s];
            const double squared = (position[i] - position[j]).squaredNorm();
            if (j != i && squared < best.squared) best = {j, squared};
        }
        int k = 0;
        for (; k < Dim; ++k) {
            if (++cell[k] <= last[k]) break;
            cell[k] = first[k];
        }
        if (k == Dim) return best;
    }
}

}  // namespace

template <int Dim>
std::vector<std::pair<Index, Index>> crowded(const AlignedVector<Vec<Dim>>& position,
                                             double nearer) {
    neighbors::CellGrid<Dim> grid;
    grid.build(position.data(), position.size(), 2 * nearer);
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t i = 0; i < position.size(); ++i) {
        const Nearest<Dim> of_i = nearestOf(grid, position, i, nearer);
        if (of_i.index == none || of_i.index < i) continue;
        if (nearestOf(grid, position, of_i.index, nearer).index == i)
            pairs.emplace_back(static_cast<Index>(i), of_i.index);
    }
    return pairs;
}

template std::vector<std::pair<Index, Index>> crowded(const AlignedVector<Vec<2>>&, double);
template std::vector<std::pair<Index, Index>> crowded(const AlignedVector<Vec<3>>&, double);

}  // namespace sphinx::fitting
