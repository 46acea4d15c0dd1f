// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

namespace sphinx::geometry {

/// Exact side of `c` seen along the line from `a` to `b`: +1 left, -1 right, 0 on the line.
/// Exact for coordinates whose products neither overflow nor underflow (about 1e-140 to 1e140).
int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c);

}  // namespace sphinx::geometry
