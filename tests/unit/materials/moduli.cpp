// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "support.h"

#include <catch2/catch.hpp>
#include <map>
#include <typeindex>

#include <Eigen/Eigenvalues>
#include <cmath>

using namespace sphinx;
using namespace sphinx::materials;

namespace {

/// Acoustic tensor of a plane wave along N in the reference coordinates: the change of the first
/// Piola-Kirchhoff traction F S N by the displacement gradient m N^T, by central differences.
template <int Dim>
Mat<Dim> acousticTensor(const ElasticSolid& solid, const Mat<Dim>& F, const Vec<Dim>& N,
                        const Fibres<Dim>& d) {
    const double step = 1e-5;
    const auto traction = [&](const Mat<Dim>& G) -> Vec<Dim> {
        return G * stress<Dim>(solid, rightCauchyGreen<Dim>(G), d) * N;
    };
    Mat<Dim> q;
    for (int k = 0; k < Dim; ++k) {
        const Mat<Dim> change = step * Vec<Dim>::Unit(k) * N.transpose();
        q.col(k) = (traction(F + change) - traction(F - change)) / (2 * step);
    }
    return (q + q.transpose()) / 2;
}

template <int Dim>
double longitudinal(const ElasticSolid& solid, const Mat<Dim>& F, const Vec<Dim>& N,
                    const Fibres<Dim>& d) {
    Eigen::SelfAdjointEigenSolver<Mat<Dim>> solver;
    solver.computeDirect(acousticTensor<Dim>(solid, F, N, d), Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[Dim - 1];
}

/// Largest over directions that are about 0.05 (2D) or 0.1 (3D) apart: at most 1 % too small.
template <int Dim>
double largestModulus(const ElasticSolid& solid, const Mat<Dim>& F, const Fibres<Dim>& d) {
    double largest = 0;
    if constexpr (Dim == 2) {
        for (double angle = 0; angle < M_PI; angle += 0.05)
            largest = std::max(
                largest, longitudinal<2>(solid, F, Vec<2>(std::cos(angle), std::sin(angle)), d));
    } else {
        for (double polar = 0; polar <= M_PI / 2 + 1e-9; polar += M_PI / 32)
            for (double angle = 0; angle < 2 * M_PI; angle += M_PI / 32)
                largest = std::max(
                    largest,
                    longitudinal<3>(solid, F,
                                    Vec<3>(std::sin(polar) * std::cos(angle),
                                           std::sin(polar) * std::sin(angle), std::cos(polar)),
                                    d));
    }
    return largest;
}

/// How much larger the estimate is than the numerical modulus: never below, `most` at most.
template <int Dim>
void checkEstimate(const ElasticSolid& solid, double bound, int trials, double most) {
    Random random(6);
    double largest_ratio = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Mat<Dim> F =
            random.rotation<Dim>() * (Mat<Dim>::Identity() + random.matrix<Dim>(bound));
        const Fibres<Dim> d = random.fibres<Dim>();
        const double estimate = tangentModulus<Dim>(solid, rightCauchyGreen<Dim>(F), d);
        const double numerical = largestModulus<Dim>(solid, F, d);
        CHECK(estimate >= numerical * (1 - 1e-7));
        largest_ratio = std::max(largest_ratio, estimate / numerical);
    }
    INFO("law " << nameOf(solid) << " in " << Dim << "D");
    CHECK(largest_ratio <= most);
}

}  // namespace

TEST_CASE("the longitudinal modulus is that of the fastest wave at rest") {
    for (const auto& solid : allSolids()) {
        INFO("law " << nameOf(*solid));
        const Mat<3> I = Mat<3>::Identity();
        const double numerical = largestModulus<3>(*solid, I, alongAxes<3>());
        CHECK(solid->longitudinalModulus() >= numerical * (1 - 1e-7));
        CHECK(solid->longitudinalModulus() <= numerical * 1.01);
    }
    const double mu = isotropicParameters().mu();
    const double lambda = isotropicParameters().lambda();
    // lambda + 2 a + 4 a_f along the fibre.
    CHECK(HolzapfelMuscle(muscleParameters()).longitudinalModulus() ==
          Approx(lambda + 4 * mu).epsilon(1e-12));
    CHECK(FiniteExtensibility(extensibleParameters()).longitudinalModulus() ==
          Approx(lambda + 2 * mu + 2 * mu / 3).epsilon(1e-12));
}

TEST_CASE("the tangent modulus is an upper estimate in any state") {
    // The ratios found are 1.35, 3.04, 1.10, 1.23 and 1.44 at strains of up to about 0.3, and 1.12
    // at most near the rest state. Loose is the anisotropic tensor, whose stiffest direction need
    // not be that of the largest stretch.
    const std::map<std::type_index, double> most{{typeid(SaintVenantKirchhoff), 1.5},
                                                 {typeid(LinearElastic), 3.5},
                                                 {typeid(NeoHookean), 1.2},
                                                 {typeid(FiniteExtensibility), 1.4},
                                                 {typeid(HolzapfelMuscle), 1.6}};
    for (const auto& solid : allSolids()) {
        const double most_of_law = most.at(typeid(*solid));
        checkEstimate<2>(*solid, 0.01, 20, 1.2);
        checkEstimate<2>(*solid, 0.2, 100, most_of_law);
        checkEstimate<3>(*solid, 0.01, 3, 1.2);
        checkEstimate<3>(*solid, 0.2, 20, most_of_law);
    }
}

TEST_CASE("the tangent modulus is exact at rest where the law is isotropic") {
    for (const auto& solid : allSolids()) {
        if (solid->hasFibres()) continue;
        const Mat<2> plane = Mat<2>::Identity();
        const Mat<3> space = Mat<3>::Identity();
        CHECK(tangentModulus<2>(*solid, plane, {}) == Approx(solid->longitudinalModulus()));
        CHECK(tangentModulus<3>(*solid, space, {}) == Approx(solid->longitudinalModulus()));
    }
}

TEST_CASE("the tangent modulus of the neo-Hookean law is exact in the plane") {
    const NeoHookean law(isotropicParameters());
    Random random(7);
    for (int trial = 0; trial < 20; ++trial) {
        const Mat<2> F = Mat<2>::Identity() + random.matrix<2>(0.3);
        const double numerical = largestModulus<2>(law, F, {});
        const double estimate = law.tangentModulus<2>(rightCauchyGreen<2>(F), {});
        CHECK(estimate >= numerical * (1 - 1e-7));
        CHECK(estimate <= numerical * 1.002);
    }
}
