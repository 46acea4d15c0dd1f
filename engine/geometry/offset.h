// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rings.h"

namespace sphinx::geometry {

/// The region with every edge moved outwards by `by` (inwards when negative) parallel to itself,
/// corners mitred. Empty when nothing remains. Length.
Rings offsetRings(const Rings& rings, double by);

}  // namespace sphinx::geometry
