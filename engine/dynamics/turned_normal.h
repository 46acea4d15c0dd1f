// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <Eigen/LU>

namespace sphinx::dynamics {

/// Normal of a surface that the deformation gradient F carries along, F^-T N / abs(F^-T N)
/// (Nanson's formula); `last` where the body has no normal N there.
template <int Dim>
Vec<Dim> turnedNormal(const Mat<Dim>& F, const Vec<Dim>& N, const Vec<Dim>& last) {
    const Vec<Dim> n = F.inverse().transpose() * N;
    const double length = n.norm();
    return length > 0 ? Vec<Dim>(n / length) : last;
}

}  // namespace sphinx::dynamics
