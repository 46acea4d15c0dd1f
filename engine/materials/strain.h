// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <algorithm>
#include <cmath>

namespace sphinx {

/// C = F^T F, exactly symmetric.
template <int Dim>
inline Mat<Dim> rightCauchyGreen(const Mat<Dim>& F) {
    Mat<Dim> C = F.transpose() * F;
    for (int c = 0; c < Dim; ++c)
        for (int d = 0; d < c; ++d) C(c, d) = C(d, c);
    return C;
}

/// Green-Lagrange strain E = (C - I)/2, guide (3).
template <int Dim>
Mat<Dim> greenStrain(const Mat<Dim>& C) {
    return 0.5 * (C - Mat<Dim>::Identity());
}

/// I_1 - 3 of the guide's (12), which is 2 tr E; in 2D plane strain, C_33 = 1.
template <int Dim>
double firstInvariantLessThree(const Mat<Dim>& C) {
    return greenStrain<Dim>(C).trace() * 2;
}

/// What the laws with ln J need of C, made from E so that nothing cancels near the rest state:
/// the error of a stress is that of E, not that of 1 - 1.
template <int Dim>
struct VolumeChange {
    double log_j;            ///< ln J = ln(det C)/2
    Mat<Dim> inverse;        ///< C^-1
    Mat<Dim> identity_less;  ///< I - C^-1

    explicit VolumeChange(const Mat<Dim>& C) {
        const Mat<Dim> E = greenStrain<Dim>(C);
        const Mat<Dim> I = Mat<Dim>::Identity();
        // With C = I + 2E: det C = 1 + 2 tr E + 4 (tr adj E) + 8 det E and
        // adj C = I + 2 (tr(E) I - E) + 4 adj E. In plane strain adj E has only its 33 component.
        double determinant_less_one;
        if constexpr (Dim == 2) {
            const double minor = E(0, 0) * E(1, 1) - E(0, 1) * E(0, 1);
            determinant_less_one = 2 * E.trace() + 4 * minor;
            identity_less = 2 * E + 4 * minor * I;
        } else {
            const Mat<3> adjugate = symmetricAdjugate(E);
            const double determinant = E.row(0).dot(adjugate.row(0));
            const double higher = 4 * adjugate.trace() + 8 * determinant;
            determinant_less_one = 2 * E.trace() + higher;
            identity_less = 2 * E - 4 * adjugate + higher * I;
        }
        log_j = 0.5 * std::log1p(determinant_less_one);
        identity_less /= 1 + determinant_less_one;
        inverse = I - identity_less;
    }

 private:
    static Mat<3> symmetricAdjugate(const Mat<3>& a) {
        Mat<3> r;
        r(0, 0) = a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2);
        r(1, 1) = a(0, 0) * a(2, 2) - a(0, 2) * a(0, 2);
        r(2, 2) = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
        r(0, 1) = r(1, 0) = a(0, 2) * a(1, 2) - a(0, 1) * a(2, 2);
        r(0, 2) = r(2, 0) = a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1);
        r(1, 2) = r(2, 1) = a(0, 1) * a(0, 2) - a(0, 0) * a(1, 2);
        return r;
    }
};

/// Upper bound of the largest eigenvalue of a symmetric matrix, from its trace and the norm of its
/// deviator: exact in 2D, and in 3D where the two smaller ones are equal (Wolkowicz & Styan 1980,
/// doi:10.1016/0024-3795(80)90258-X).
template <int Dim>
double largestEigenvalueBound(const Mat<Dim>& a) {
    const double mean = a.trace() / Dim;
    const double deviator = (a - mean * Mat<Dim>::Identity()).squaredNorm();
    return mean + std::sqrt(deviator * (Dim - 1) / Dim);
}

}  // namespace sphinx
