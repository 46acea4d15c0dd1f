// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/isotropic.h"
#include "materials/strain.h"

namespace sphinx::materials {

/// W = mu tr E - mu ln J + lambda/2 (ln J)^2, guide (9), hence
/// S = mu (I - C^-1) + lambda ln J C^-1.
class NeoHookean final : public IsotropicSolid {
 public:
    using IsotropicSolid::IsotropicSolid;

    template <int Dim, class Number = double>
    MatOf<Dim, Number> stress(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        const VolumeChange<Dim, Number> v(C);
        return mu() * v.identity_less + lambda() * v.log_j * v.inverse;
    }
    template <int Dim>
    double energy(const Mat<Dim>& C, const Fibres<Dim>&) const {
        const double log_j = VolumeChange<Dim>(C).log_j;
        return mu() * (firstInvariantLessThree<Dim>(C) / 2 - log_j) + lambda() / 2 * log_j * log_j;
    }
    /// m.Q.m = mu + (lambda (1 - ln J) + mu)(m.g)^2 with g = F^-T N, |g|^2 = N.C^-1.N: exact in 2D.
    template <int Dim, class Number = double>
    Number tangentModulus(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        const VolumeChange<Dim, Number> v(C);
        using std::max;
        const Number volumetric = max(Number(0), lambda() * (1 - v.log_j) + mu());
        return mu() + volumetric * largestEigenvalueBound<Dim, Number>(v.inverse);
    }
};

}  // namespace sphinx::materials
