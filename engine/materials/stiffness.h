// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

namespace sphinx::materials {

/// A constant elasticity tensor, S = stiffness (E_11, E_22, E_33, 2 E_23, 2 E_13, 2 E_12);
/// pressure.
using Stiffness = Eigen::Matrix<double, 6, 6>;

/// The tensor in x, y, z, given in the axes that are the columns of the rotation `axes`.
Stiffness rotated(const Stiffness& stiffness, const Mat<3>& axes);

/// Largest longitudinal modulus: rho c^2 of the fastest plane wave of any direction. (Found by
/// climbing from many directions; the tensor must be positive definite.)
double largestLongitudinalModulus(const Stiffness& stiffness);

/// Averages over all directions at equal strain (Voigt): exact bulk and shear modulus if isotropic.
double averageBulkModulus(const Stiffness& stiffness);
double averageShearModulus(const Stiffness& stiffness);

}  // namespace sphinx::materials
