// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/types.h"

#include <utility>
#include <vector>

namespace sphinx::fitting {

/// Pairs of points nearer than that, each of which is the other's nearest.
template <int Dim>
std::vector<std::pair<Index, Index>> crowded(const AlignedVector<Vec<Dim>>& position,
                                             double nearer);

}  // namespace sphinx::fitting
