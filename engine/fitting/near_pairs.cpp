// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/near_pairs.h"

#include "neighbors/cell_grid.h"

#include <algorithm>
#include <array>

namespace sphinx::fitting {

template <int Dim>
NearPairs nearPairs(const AlignedVector<Vec<Dim>>& position, double nearer) {
    neighbors::CellGrid<Dim> grid;
    grid.build(position.data(), position.size(), nearer);
    NearPairs pairs;
    pairs.first.push_back(0);
    for (std::size_t i = 0; i < position.size(); ++i) {
        std::array<int, Dim> first{}, last{};
        for (int k = 0; k < Dim; ++k) {
            const auto at = static_cast<int>((position[i][k] - grid.origin()[k]) / grid.cellSize());
            first[k] = std::max(at - 1, 0);
            last[k] = std::min(at + 1, grid.counts()[k] - 1);
        }
        std::array<int, Dim> cell = first;
        for (int k = 0; k < Dim;) {
            const std::size_t c = grid.cellIndex(cell);
            for (std::size_t s = grid.start(c); s < grid.start(c + 1); ++s) {
                const Index j = grid.order()[s];
                if (j != i && (position[i] - position[j]).squaredNorm() < nearer * nearer)
                    pairs.neighbor.push_back(j);
            }
            for (k = 0; k < Dim; ++k) {
                if (++cell[k] <= last[k]) break;
                cell[k] = first[k];
            }
        }
        pairs.first.push_back(pairs.neighbor.size());
    }
    return pairs;
}

template NearPairs nearPairs(const AlignedVector<Vec<2>>&, double);
template NearPairs nearPairs(const AlignedVector<Vec<3>>&, double);

}  // namespace sphinx::fitting
