// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/multibody/mechanism.h"
#include "dynamics/words.h"
#include "input/types/values.h"

#include <vector>

namespace sphinx::dynamics::multibody {

struct MassProperties {
    std::size_t particles = 0;
    double mass = 0;
    Vector center = Vector::Zero();
    Matrix inertia = Matrix::Zero();  ///< about the centre, axes of the case
};

/// Of the particles of bodies and parts where they began, each a cube (2D: a square) of its volume,
/// whose own moment of inertia is m d^2/6 about each of its axes, d^Dim = V. Zero where their
/// materials state no density.
template <int Dim>
MassProperties massProperties(const World<Dim>& world, const std::vector<input::Name>& names);

}  // namespace sphinx::dynamics::multibody
