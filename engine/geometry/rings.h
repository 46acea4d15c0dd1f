// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <string>
#include <vector>

namespace sphinx::geometry {

/// Closed polyline, the last point joined to the first and not repeated.
using Ring = std::vector<Vec<2>>;
/// A region of the plane by its boundary, the region on the left of every ring: outer rings run
/// counter-clockwise, holes clockwise. Which hole lies in which outer ring follows from the points.
using Rings = std::vector<Ring>;

inline double cross(const Vec<2>& a, const Vec<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Positive when the ring runs counter-clockwise. Length squared.
double signedArea(const Ring& ring);
Box<2> boundsOf(const Rings& rings);

/// Without repeated points and without rings thinner than the rounding of their coordinates.
Rings withoutSlivers(Rings rings);

/// Checks that `ring` bounds a simple polygon and turns it counter-clockwise. `name` stands before
/// the messages ("" or "hole 1: "). Throws ShapeError.
Ring simpleRing(Ring ring, const std::string& name);

/// Checks that the simple ring `hole` lies in the simple ring `outer`; they may touch in points.
/// Throws ShapeError.
void checkHole(const Ring& outer, const Ring& hole, const std::string& name);

}  // namespace sphinx::geometry
