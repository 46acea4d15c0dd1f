// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/wide.h"

#include <cmath>

// Number is double, or Wide for eight particles at a time.
namespace sphinx::materials {

/// C = F^T F, exactly symmetric.
template <int Dim, class Number = double>
inline MatOf<Dim, Number> rightCauchyGreen(const MatOf<Dim, Number>& F) {
    MatOf<Dim, Number> C = F.transpose() * F;
    for (int c = 0; c < Dim; ++c)
        for (int d = 0; d < c; ++d) C(c, d) = C(d, c);
    return C;
}

/// Green-Lagrange strain E = (C - I)/2, guide (3).
template <int Dim, class Number = double>
inline MatOf<Dim, Number> greenStrain(const MatOf<Dim, Number>& C) {
    return 0.5 * (C - MatOf<Dim, Number>::Identity());
}

/// I_1 - 3 of the guide's (12), which is 2 tr E; in 2D plane strain, C_33 = 1.
template <int Dim, class Number = double>
inline Number firstInvariantLessThree(const MatOf<Dim, Number>& C) {
    return greenStrain<Dim, Number>(C).trace() * 2;
}

/// What the laws with ln J need of C, made from E so that nothing cancels near the rest state:
/// the error of a stress is that of E, not that of 1 - 1.
template <int Dim, class Number = double>
struct VolumeChange {
    using Matrix = MatOf<Dim, Number>;
    Number log_j;          ///< ln J = ln(det C)/2
    Matrix inverse;        ///< C^-1
    Matrix identity_less;  ///< I - C^-1

    explicit VolumeChange(const Matrix& C) {
        using std::log1p;
        const Matrix E = greenStrain<Dim, Number>(C);
        const Matrix I = Matrix::Identity();
        // With C = I + 2E: det C = 1 + 2 tr E + 4 (tr adj E) + 8 det E and
        // adj C = I + 2 (tr(E) I - E) + 4 adj E. In plane strain adj E has only its 33 component.
        Number determinant_less_one;
        if constexpr (Dim == 2) {
            const Number minor = E(0, 0) * E(1, 1) - E(0, 1) * E(0, 1);
            determinant_less_one = 2 * E.trace() + 4 * minor;
            identity_less = 2 * E + 4 * minor * I;
        } else {
            const Matrix adjugate = symmetricAdjugate(E);
            const Number determinant = E.row(0).dot(adjugate.row(0));
            const Number higher = 4 * adjugate.trace() + 8 * determinant;
            determinant_less_one = 2 * E.trace() + higher;
            identity_less = 2 * E - 4 * adjugate + higher * I;
        }
        log_j = 0.5 * log1p(determinant_less_one);
        identity_less /= 1 + determinant_less_one;
        inverse = I - identity_less;
    }

 private:
    static Matrix symmetricAdjugate(const Matrix& a) {
        Matrix r;
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
template <class Number = double>
struct EigenvalueBound {
    Number mean;
    Number above;  ///< of the largest above the mean; goes with the deviator

    Number largest() const { return mean + above; }
};
template <int Dim, class Number = double>
inline EigenvalueBound<Number> eigenvalueBound(const MatOf<Dim, Number>& a) {
    using std::sqrt;
    const Number mean = a.trace() / Dim;
    const Number deviator = (a - mean * MatOf<Dim, Number>::Identity()).squaredNorm();
    return {mean, sqrt(deviator * (Dim - 1) / Dim)};
}
template <int Dim, class Number = double>
inline Number largestEigenvalueBound(const MatOf<Dim, Number>& a) {
    return eigenvalueBound<Dim, Number>(a).largest();
}

/// Bound of the tangent modulus of a law that is linear in E, longitudinal |a|^2 + N.S.N with
/// a = F^T m: |a|^2 is at most the largest eigenvalue of C, and N.S.N that of the stress S at C.
/// Pressure.
template <class Number>
inline Number linearTangentBound(double longitudinal, Number largest_of_C, Number largest_of_S) {
    using std::max;
    return longitudinal * largest_of_C + max(Number(0), largest_of_S);
}

}  // namespace sphinx::materials
