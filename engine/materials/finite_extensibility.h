// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/isotropic.h"
#include "materials/strain.h"

namespace sphinx::materials {

struct FiniteExtensibilityParameters : IsotropicParameters {
    double extensibility = 0;  ///< J_m, the value that I_1 - 3 never reaches
};

/// W = -mu/2 J_m ln(1 - (I_1 - 3)/J_m) - mu ln J + lambda/2 (ln J)^2, guide (10);
/// S = p I + (lambda ln J - mu) C^-1 with p = mu/(1 - (I_1 - 3)/J_m), guide (11).
/// Near the rest state W = (lambda/2 + mu/J_m) tr(E)^2 + mu E:E: the bulk modulus is larger than
/// that of the constants given by 2 mu/J_m.
class FiniteExtensibility final : public IsotropicSolid {
 public:
    using Parameters = FiniteExtensibilityParameters;

    explicit FiniteExtensibility(const Parameters& p)
        : IsotropicSolid(p), extensibility_(p.extensibility) {}

    double extensibility() const { return extensibility_; }
    double bulkModulus() const override {
        return IsotropicSolid::bulkModulus() + 2 * mu() / extensibility_;
    }

    template <int Dim, class Number = double>
    MatOf<Dim, Number> stress(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        const VolumeChange<Dim, Number> v(C);
        const Number used = usedUp<Dim, Number>(C);
        // p I - mu C^-1 = (p - mu) I + mu (I - C^-1)
        return mu() * used / (1 - used) * MatOf<Dim, Number>::Identity() + mu() * v.identity_less +
               lambda() * v.log_j * v.inverse;
    }
    template <int Dim>
    double energy(const Mat<Dim>& C, const Fibres<Dim>&) const {
        const double log_j = VolumeChange<Dim>(C).log_j;
        return -mu() / 2 * extensibility_ * std::log1p(-usedUp<Dim>(C)) - mu() * log_j +
               lambda() / 2 * log_j * log_j;
    }
    template <int Dim, class Number = double>
    Truth<Number> admissible(const MatOf<Dim, Number>& C) const {
        return usedUp<Dim, Number>(C) < 1;
    }
    /// m.Q.m = p + (lambda (1 - ln J) + mu)(m.g)^2 + 2 p^2/(mu J_m) (m.F N)^2 with g = F^-T N.
    template <int Dim, class Number = double>
    Number tangentModulus(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        const VolumeChange<Dim, Number> v(C);
        using std::max;
        const Number p = mu() / (1 - usedUp<Dim, Number>(C));
        const Number volumetric = max(Number(0), lambda() * (1 - v.log_j) + mu());
        return p + volumetric * largestEigenvalueBound<Dim, Number>(v.inverse) +
               2 * p * p / (mu() * extensibility_) * largestEigenvalueBound<Dim, Number>(C);
    }

 private:
    /// (I_1 - 3)/J_m.
    template <int Dim, class Number = double>
    Number usedUp(const MatOf<Dim, Number>& C) const {
        return firstInvariantLessThree<Dim, Number>(C) / extensibility_;
    }

    double extensibility_;
};

}  // namespace sphinx::materials
