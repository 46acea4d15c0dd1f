// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "materials/elastic_laws.h"
#include "materials/strain.h"

#include <Eigen/Geometry>
#include <memory>
#include <random>
#include <string>
#include <typeinfo>
#include <vector>

namespace sphinx::materials {

/// The laws of the tables: E = 1, nu = 0.3, J_m = 3; the muscle of a = mu, a_f = mu/2, a_s = mu/4,
/// a_fs = mu/5 and all b = 1.
inline IsotropicParameters isotropicParameters() {
    IsotropicParameters p;
    p.density = 1;
    p.youngs_modulus = 1;
    p.poisson_ratio = 0.3;
    return p;
}

inline FiniteExtensibilityParameters extensibleParameters() {
    FiniteExtensibilityParameters p;
    static_cast<IsotropicParameters&>(p) = isotropicParameters();
    p.extensibility = 3;
    return p;
}

inline HolzapfelMuscleParameters muscleParameters() {
    const double mu = isotropicParameters().mu();
    HolzapfelMuscleParameters p;
    p.density = 1;
    p.lame_lambda = isotropicParameters().lambda();
    p.a = mu, p.a_f = mu / 2, p.a_s = mu / 4, p.a_fs = mu / 5;
    p.b = p.b_f = p.b_s = p.b_fs = 1;
    p.fibre.assign(3, input::FieldExpression(0));
    p.sheet = p.fibre;
    p.fibre[0] = p.sheet[1] = input::FieldExpression(1);
    return p;
}

/// A spruce-like solid, E_1 = 1, with its axes turned out of x, y and z.
inline LinearElasticParameters orthotropicParameters() {
    LinearElasticParameters p;
    p.density = 1;
    p.youngs_modulus_1 = 1, p.youngs_modulus_2 = 0.4, p.youngs_modulus_3 = 0.2;
    p.poisson_ratio_12 = 0.3, p.poisson_ratio_13 = 0.25, p.poisson_ratio_23 = 0.35;
    p.shear_modulus_12 = 0.15, p.shear_modulus_13 = 0.12, p.shear_modulus_23 = 0.08;
    p.axis_1 = {{1, 2, 0.5}, 3};
    p.axis_2 = {{-2, 1, 0}, 3};
    return p;
}

/// Of the final class, for messages.
inline const char* nameOf(const ElasticSolid& solid) { return typeid(solid).name(); }

/// One solid of each law.
inline std::vector<std::unique_ptr<ElasticSolid>> allSolids() {
    std::vector<std::unique_ptr<ElasticSolid>> solids;
    solids.push_back(std::make_unique<SaintVenantKirchhoff>(isotropicParameters()));
    solids.push_back(std::make_unique<LinearElastic>(orthotropicParameters()));
    solids.push_back(std::make_unique<NeoHookean>(isotropicParameters()));
    solids.push_back(std::make_unique<FiniteExtensibility>(extensibleParameters()));
    solids.push_back(std::make_unique<HolzapfelMuscle>(muscleParameters()));
    return solids;
}

template <int Dim>
Fibres<Dim> alongAxes() {
    return {Vec<Dim>::Unit(0), Vec<Dim>::Unit(1)};
}

template <int Dim>
Mat<Dim> stress(const ElasticSolid& solid, const Mat<Dim>& C, const Fibres<Dim>& d) {
    return withLaw(solid, [&](const auto& law) { return law.template stress<Dim>(C, d); });
}
template <int Dim>
double energy(const ElasticSolid& solid, const Mat<Dim>& C, const Fibres<Dim>& d) {
    return withLaw(solid, [&](const auto& law) { return law.template energy<Dim>(C, d); });
}
template <int Dim>
double tangentModulus(const ElasticSolid& solid, const Mat<Dim>& C, const Fibres<Dim>& d) {
    return withLaw(solid, [&](const auto& law) { return law.template tangentModulus<Dim>(C, d); });
}

/// Numbers of a test, the same in each run.
struct Random {
    explicit Random(unsigned seed) : engine(seed) {}

    double within(double bound) {
        return std::uniform_real_distribution<double>(-bound, bound)(engine);
    }
    template <int Dim>
    Mat<Dim> matrix(double bound) {
        Mat<Dim> m;
        for (int k = 0; k < Dim * Dim; ++k) m.data()[k] = within(bound);
        return m;
    }
    template <int Dim>
    Vec<Dim> direction() {
        Vec<Dim> n;
        do
            for (int k = 0; k < Dim; ++k) n[k] = within(1);
        while (n.norm() < 0.1 || n.norm() > 1);
        return n.normalized();
    }
    template <int Dim>
    Mat<Dim> rotation() {
        if constexpr (Dim == 2)
            return Eigen::Rotation2D<double>(within(3.2)).toRotationMatrix();
        else
            return Eigen::AngleAxis<double>(within(3.2), direction<3>()).toRotationMatrix();
    }
    template <int Dim>
    Fibres<Dim> fibres() {
        const Mat<Dim> axes = rotation<Dim>();
        return {axes.col(0), axes.col(1)};
    }

    std::mt19937 engine;
};

}  // namespace sphinx::materials
