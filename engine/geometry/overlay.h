// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rings.h"

#include <vector>

namespace sphinx::geometry {

enum class Rule {
    any,             ///< union
    all,             ///< intersection
    first_not_rest,  ///< difference
};

/// The points of the plane that the operands cover by the rule, computed exactly; only the corners
/// are rounded, at the end, and corners of the input come back bit by bit. A point is covered by an
/// operand when its rings wind around it a positive number of times, so rings may overlap and cross
/// each other and themselves (rounding does that, and so do offsets).
Rings overlay(const std::vector<Rings>& operands, Rule rule);

}  // namespace sphinx::geometry
