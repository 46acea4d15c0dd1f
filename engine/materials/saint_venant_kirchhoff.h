// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/isotropic.h"
#include "materials/strain.h"

namespace sphinx::materials {

/// S = lambda tr(E) I + 2 mu E, W = lambda/2 tr(E)^2 + mu E:E; guide (8). Linear in E for any
/// rotation, but it softens under large compression.
class SaintVenantKirchhoff final : public IsotropicSolid {
 public:
    using IsotropicSolid::IsotropicSolid;

    template <int Dim, class Number = double>
    MatOf<Dim, Number> stress(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        using Matrix = MatOf<Dim, Number>;
        const Matrix E = greenStrain<Dim, Number>(C);
        return lambda() * E.trace() * Matrix::Identity() + 2 * mu() * E;
    }
    template <int Dim>
    double energy(const Mat<Dim>& C, const Fibres<Dim>&) const {
        const Mat<Dim> E = greenStrain<Dim>(C);
        return lambda() / 2 * E.trace() * E.trace() + mu() * E.squaredNorm();
    }
    /// m.Q.m = (lambda + mu)(a.N)^2 + mu |a|^2 + N.S.N with a = F^T m. The deviator of S is mu
    /// times that of C = I + 2E, its mean (lambda + 2 mu/Dim) tr E.
    template <int Dim, class Number = double>
    Number tangentModulus(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        const EigenvalueBound<Number> of_C = eigenvalueBound<Dim, Number>(C);
        const Number trace = greenStrain<Dim, Number>(C).trace();
        return linearTangentBound<Number>(lambda() + 2 * mu(), of_C.largest(),
                                          (lambda() + 2 * mu() / Dim) * trace + mu() * of_C.above);
    }
};

}  // namespace sphinx::materials
