// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"

#include <vector>

namespace sphinx::fitting {

/// The neighbors of point i are neighbor[first[i]] to neighbor[first[i + 1] - 1].
struct NearPairs {
    std::vector<std::size_t> first;
    std::vector<Index> neighbor;
};

/// Points nearer to each other than that.
template <int Dim>
NearPairs nearPairs(const AlignedVector<Vec<Dim>>& position, double nearer);

}  // namespace sphinx::fitting
