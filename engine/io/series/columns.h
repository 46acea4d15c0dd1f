// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/series/quantity.h"
#include "particles/field.h"

#include <string>
#include <vector>

namespace sphinx::io {

/// "x", "y" (and "z") of a vector, "xx", "xy", ... row by row of a matrix, none of a scalar.
template <int Dim>
std::vector<std::string> componentLabels(particles::Rank rank);

/// Labels of a moment (dynamics/load.h): none in 2D, where it has one component.
template <int Dim>
std::vector<std::string> momentLabels() {
    return componentLabels<3>(Dim == 2 ? particles::Rank::scalar : particles::Rank::vector);
}

/// Labels of values at several points, numbered from 0: "3" or "3_x"; at a single point those of
/// the components alone.
std::vector<std::string> pointLabels(std::size_t points,
                                     const std::vector<std::string>& components);

}  // namespace sphinx::io
