// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/types/values.h"
#include "materials/elastic_solid.h"
#include "materials/stiffness.h"
#include "materials/strain.h"

#include <optional>
#include <string>
#include <vector>

namespace sphinx::materials {

/// Either the nine engineering constants of an orthotropic solid or a stiffness matrix. nu_12 is
/// the contraction along axis 2 over the extension along axis 1 that a stress along axis 1 makes.
struct LinearElasticParameters {
    double density = 0;  ///< rho0, mass/length^3
    double damping = 0;  ///< eta of (16), mass/(length time)
    std::optional<double> youngs_modulus_1, youngs_modulus_2, youngs_modulus_3;  ///< pressure
    std::optional<double> poisson_ratio_12, poisson_ratio_13, poisson_ratio_23;
    std::optional<double> shear_modulus_12, shear_modulus_13, shear_modulus_23;  ///< pressure
    std::vector<std::vector<double>> stiffness;  ///< 6 x 6, see Stiffness
    input::Coordinates axis_1, axis_2;           ///< empty: x and y

    /// What is wrong with the constants or the axes, or empty.
    std::string constantsViolation() const;
    std::string axesViolation() const;
    /// In x, y, z. Asks for parameters without violation.
    Stiffness tensor() const;
};

/// S = c : E with a constant elasticity tensor c, W = E:c:E/2; guide (6). Isotropic:
/// SaintVenantKirchhoff.
class LinearElastic final : public ElasticSolid {
 public:
    using Parameters = LinearElasticParameters;

    explicit LinearElastic(const Parameters& p);

    /// In x, y, z.
    const Stiffness& stiffness() const { return stiffness_; }
    double longitudinalModulus() const override { return longitudinal_modulus_; }
    double bulkModulus() const override { return averageBulkModulus(stiffness_); }
    double shearModulus() const override { return averageShearModulus(stiffness_); }

    template <int Dim, class Number = double>
    MatOf<Dim, Number> stress(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>&) const {
        MatOf<Dim, Number> S;
        const auto e = strains<Number>(greenStrain<Dim, Number>(C));
        if constexpr (Dim == 2) {
            const VecOf<3, Number> s = plane_ * e;
            S << s[0], s[2], s[2], s[1];
        } else {
            const VecOf<6, Number> s = stiffness_ * e;
            S << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
        }
        return S;
    }
    template <int Dim>
    double energy(const Mat<Dim>& C, const Fibres<Dim>& fibres) const {
        return 0.5 * stress<Dim>(C, fibres).cwiseProduct(greenStrain<Dim>(C)).sum();
    }
    /// m.Q.m = (a N):c:(a N) + N.S.N with a = F^T m.
    template <int Dim, class Number = double>
    Number tangentModulus(const MatOf<Dim, Number>& C, const Fibres<Dim, Number>& fibres) const {
        const MatOf<Dim, Number> S = stress<Dim, Number>(C, fibres);
        return linearTangentBound<Number>(longitudinal_modulus_,
                                          largestEigenvalueBound<Dim, Number>(C),
                                          largestEigenvalueBound<Dim, Number>(S));
    }

 private:
    template <class Number>
    static VecOf<3, Number> strains(const MatOf<2, Number>& E) {
        return {E(0, 0), E(1, 1), 2 * E(0, 1)};
    }
    template <class Number>
    static VecOf<6, Number> strains(const MatOf<3, Number>& E) {
        VecOf<6, Number> e;
        e << E(0, 0), E(1, 1), E(2, 2), 2 * E(1, 2), 2 * E(0, 2), 2 * E(0, 1);
        return e;
    }

    Stiffness stiffness_;
    Mat<3> plane_;  ///< rows and columns 11, 22 and 12 of it
    double longitudinal_modulus_;
};

}  // namespace sphinx::materials
