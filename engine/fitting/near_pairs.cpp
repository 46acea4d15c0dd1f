// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/near_pairs.h"

namespace sphinx::fitting {

template <int Dim>
NearPairs nearPairs(const AlignedVector<Vec<Dim>>& position, double nearer) {
    neighbors::CellGrid<Dim> grid;
    grid.build(position.data(), position.size(), nearer);
    NearPairs pairs;
    pairs.first.push_back(0);
    for (std::size_t i = 0; i < position.size(); ++i) {
        forEachAround(grid, position[i], [&](Index j) {
            if (j != i && (position[i] - position[j]).squaredNorm() < nearer * nearer)
                pairs.neighbor.push_back(j);
        });
        pairs.first.push_back(pairs.neighbor.size());
    }
    return pairs;
}

template NearPairs nearPairs(const AlignedVector<Vec<2>>&, double);
template NearPairs nearPairs(const AlignedVector<Vec<3>>&, double);

}  // namespace sphinx::fitting
