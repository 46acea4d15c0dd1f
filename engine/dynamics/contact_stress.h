// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"

#include <vector>

namespace sphinx::dynamics {

/// Contact knows the normals of an elastic body, n = F^-T N/abs(F^-T N), so its energy depends on F
/// as that of the material does: what it adds to the first Piola-Kirchhoff stress of the particles
/// at the surface. A contact method keeps one for each of its elastic bodies.
template <int Dim>
struct ContactStress {
    const Body<Dim>* body = nullptr;
    std::vector<Index> particles;
    std::vector<Mat<Dim>> stress;
};

}  // namespace sphinx::dynamics
