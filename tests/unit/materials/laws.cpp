// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "support.h"

#include <catch2/catch.hpp>

#include <type_traits>

using namespace sphinx;
using namespace sphinx::materials;

namespace {

/// A deformation of up to about 30 %, inside of what every law admits.
template <int Dim>
Mat<Dim> deformation(Random& random) {
    return random.rotation<Dim>() * (Mat<Dim>::Identity() + random.matrix<Dim>(0.15));
}

template <int Dim>
void checkStressIsDerivativeOfEnergy(const ElasticSolid& solid) {
    Random random(1);
    for (int trial = 0; trial < 50; ++trial) {
        const Mat<Dim> C = rightCauchyGreen<Dim>(deformation<Dim>(random));
        const Fibres<Dim> d = random.fibres<Dim>();
        const Mat<Dim> S = stress<Dim>(solid, C, d);
        CHECK((S - S.transpose()).norm() <= 1e-15 * S.norm());
        for (int i = 0; i < Dim; ++i)
            for (int j = i; j < Dim; ++j) {
                // Central difference of W along the symmetric pair (i, j): dW = S:dC/2.
                const double step = 1e-4;
                Mat<Dim> change = Mat<Dim>::Zero();
                change(i, j) = change(j, i) = step;
                const double slope =
                    (energy<Dim>(solid, C + change, d) - energy<Dim>(solid, C - change, d)) /
                    (2 * step);
                CHECK(slope == Approx(i == j ? S(i, j) / 2 : S(i, j)).epsilon(1e-6).margin(1e-6));
            }
    }
}

template <int Dim>
void checkFrameIndifference(const ElasticSolid& solid) {
    Random random(2);
    for (int trial = 0; trial < 50; ++trial) {
        const Mat<Dim> F = deformation<Dim>(random);
        const Fibres<Dim> d = random.fibres<Dim>();
        const Mat<Dim> S = stress<Dim>(solid, rightCauchyGreen<Dim>(F), d);
        const Mat<Dim> turned = random.rotation<Dim>() * F;
        CHECK((stress<Dim>(solid, rightCauchyGreen<Dim>(turned), d) - S).norm() <= 1e-13);
    }
}

template <int Dim>
void checkRestIsFree(const ElasticSolid& solid) {
    Random random(3);
    const Mat<Dim> I = Mat<Dim>::Identity();
    CHECK(stress<Dim>(solid, I, alongAxes<Dim>()).norm() == 0);
    CHECK(energy<Dim>(solid, I, alongAxes<Dim>()) == 0);
    double largest = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const Mat<Dim> C = rightCauchyGreen<Dim>(random.rotation<Dim>());
        const Fibres<Dim> d = random.fibres<Dim>();
        largest = std::max(largest, stress<Dim>(solid, C, d).cwiseAbs().maxCoeff());
        CHECK(std::abs(energy<Dim>(solid, C, d)) <= 1e-15);
    }
    CHECK(largest <= 1e-14);
}

/// Stress and modulus of eight deformations at a time are those of each alone.
template <int Dim>
void checkEightAtATime(const ElasticSolid& solid) {
    Random random(6);
    MatOf<Dim, Wide> C;
    Fibres<Dim, Wide> d;
    Mat<Dim> one_C[lane_count];
    Fibres<Dim> one_d[lane_count];
    for (int k = 0; k < lane_count; ++k) {
        one_C[k] = rightCauchyGreen<Dim>(deformation<Dim>(random));
        one_d[k] = random.fibres<Dim>();
        for (int c = 0; c < Dim * Dim; ++c) C.data()[c].at[k] = one_C[k].data()[c];
        for (int c = 0; c < Dim; ++c) d.fibre[c].at[k] = one_d[k].fibre[c];
        for (int c = 0; c < Dim; ++c) d.sheet[c].at[k] = one_d[k].sheet[c];
    }
    withLaw(solid, [&](const auto& law) {
        CHECK(maskBits(law.template admissible<Dim, Wide>(C)) == all_lanes);
        const MatOf<Dim, Wide> S = law.template stress<Dim, Wide>(C, d);
        const Wide modulus = law.template tangentModulus<Dim, Wide>(C, d);
        for (int k = 0; k < lane_count; ++k) {
            const Mat<Dim> one = law.template stress<Dim>(one_C[k], one_d[k]);
            for (int c = 0; c < Dim * Dim; ++c)
                CHECK(std::abs(S.data()[c].at[k] - one.data()[c]) <= 1e-14);
            CHECK(modulus.at[k] ==
                  Approx(law.template tangentModulus<Dim>(one_C[k], one_d[k])).epsilon(1e-14));
        }
    });
}

/// The law's own numbers for Hooke's law at small strain.
void checkHooke(const ElasticSolid& solid, double lambda, double mu) {
    Random random(4);
    for (int trial = 0; trial < 50; ++trial) {
        const Mat<3> H = random.matrix<3>(1e-6);
        const Mat<3> e = (H + H.transpose()) / 2;
        const Mat<3> expected = lambda * e.trace() * Mat<3>::Identity() + 2 * mu * e;
        const Mat<3> F = Mat<3>::Identity() + H;
        const Mat<3> S = stress<3>(solid, rightCauchyGreen<3>(F), {});
        CHECK((S - expected).norm() <= 1e-5 * expected.norm());
    }
    CHECK(solid.longitudinalModulus() == Approx(lambda + 2 * mu).epsilon(1e-14));
    CHECK(solid.bulkModulus() == Approx(lambda + 2. / 3 * mu).epsilon(1e-14));
    CHECK(solid.shearModulus() == Approx(mu).epsilon(1e-14));
}

/// Of each law, in both dimensions.
template <class Check>
void forAllSolids(Check check) {
    for (const auto& solid : allSolids()) {
        INFO("law " << nameOf(*solid));
        check.template operator()<2>(*solid);
        check.template operator()<3>(*solid);
    }
}

}  // namespace

TEST_CASE("withLaw gives the class of the solid") {
    const auto solids = allSolids();
    int found = 0;
    for (const auto& solid : solids)
        withLaw(*solid, [&](const auto& law) {
            using Law = std::decay_t<decltype(law)>;
            found += dynamic_cast<const Law*>(solid.get()) != nullptr;
            CHECK(Law::uses_fibres == solid->hasFibres());
        });
    CHECK(found == 5);
}

TEST_CASE("stress is the derivative of the energy") {
    forAllSolids(
        []<int Dim>(const ElasticSolid& solid) { checkStressIsDerivativeOfEnergy<Dim>(solid); });
}

TEST_CASE("eight deformations at a time are each of them") {
    forAllSolids([]<int Dim>(const ElasticSolid& solid) { checkEightAtATime<Dim>(solid); });
}

TEST_CASE("a rotation on top of a deformation changes no stress") {
    forAllSolids([]<int Dim>(const ElasticSolid& solid) { checkFrameIndifference<Dim>(solid); });
}

TEST_CASE("a rotated solid at rest is free of stress and energy") {
    forAllSolids([]<int Dim>(const ElasticSolid& solid) { checkRestIsFree<Dim>(solid); });
}

TEST_CASE("small strains obey Hooke's law") {
    const double lambda = isotropicParameters().lambda();
    const double mu = isotropicParameters().mu();
    CHECK(lambda == Approx(0.3 / (1.3 * 0.4)));
    CHECK(mu == Approx(1 / 2.6));
    checkHooke(SaintVenantKirchhoff(isotropicParameters()), lambda, mu);
    checkHooke(NeoHookean(isotropicParameters()), lambda, mu);
    // The logarithm of (10) resists a change of volume as well.
    checkHooke(FiniteExtensibility(extensibleParameters()), lambda + 2 * mu / 3, mu);
    HolzapfelMuscleParameters p = muscleParameters();
    p.a_f = p.a_s = p.a_fs = 0;
    checkHooke(HolzapfelMuscle(p), lambda, mu);
}

TEST_CASE("plane strain is the 3D law with C_33 = 1") {
    Random random(5);
    for (const auto& solid : allSolids())
        for (int trial = 0; trial < 20; ++trial) {
            const Mat<2> C = rightCauchyGreen<2>(deformation<2>(random));
            Mat<3> space = Mat<3>::Identity();
            space.topLeftCorner<2, 2>() = C;
            const Fibres<2> d = random.fibres<2>();
            Fibres<3> d3;
            d3.fibre << d.fibre, 0;
            d3.sheet << d.sheet, 0;
            const Mat<3> S = stress<3>(*solid, space, d3);
            CHECK((S.topLeftCorner<2, 2>() - stress<2>(*solid, C, d)).norm() <= 1e-13);
            CHECK(energy<3>(*solid, space, d3) == Approx(energy<2>(*solid, C, d)).epsilon(1e-13));
        }
}

TEST_CASE("simple shear has its closed forms") {
    const double lambda = isotropicParameters().lambda();
    const double mu = isotropicParameters().mu();
    const double g = 0.7;
    Mat<2> F = Mat<2>::Identity();
    F(0, 1) = g;
    const Mat<2> C = rightCauchyGreen<2>(F);
    const Mat<2> cauchy = F * stress<2>(NeoHookean(isotropicParameters()), C, {}) * F.transpose();
    CHECK(cauchy(0, 1) == Approx(mu * g).epsilon(1e-14));
    CHECK(cauchy(0, 0) == Approx(mu * g * g).epsilon(1e-14));
    CHECK(cauchy(1, 1) == Approx(0).margin(1e-15));
    const Mat<2> S = stress<2>(SaintVenantKirchhoff(isotropicParameters()), C, {});
    CHECK(S(0, 1) == Approx(mu * g).epsilon(1e-14));
    CHECK(S(0, 0) == Approx(lambda * g * g / 2).epsilon(1e-14));
    CHECK(S(1, 1) == Approx((lambda / 2 + mu) * g * g).epsilon(1e-14));
}

TEST_CASE("the energy of the muscle is positive and has the corrected constants") {
    const HolzapfelMuscle muscle(muscleParameters());
    const double mu = isotropicParameters().mu();
    const double lambda = isotropicParameters().lambda();
    const double l = 1.2;
    const Mat<3> C = Vec<3>(l * l, 1, 1).asDiagonal();
    const double i = l * l - 1;
    const double expected = mu / 2 * (std::exp(i - 2 * std::log(l)) - 1) +
                            lambda / 2 * std::log(l) * std::log(l) + mu / 4 * (std::exp(i * i) - 1);
    CHECK(energy<3>(muscle, C, alongAxes<3>()) == Approx(expected).epsilon(1e-13));
}

TEST_CASE("a finite extensibility ends at J_m") {
    const FiniteExtensibility law(extensibleParameters());
    const double limit = std::sqrt(1 + 3.);
    const auto stretched = [](double l) {
        const Mat<3> C = Vec<3>(l * l, 1, 1).asDiagonal();
        return C;
    };
    CHECK(law.admissible<3>(stretched(limit * (1 - 1e-12))));
    CHECK_FALSE(law.admissible<3>(stretched(limit)));
    CHECK_FALSE(law.admissible<3>(stretched(limit * (1 + 1e-12))));
    CHECK(law.stress<3>(stretched(limit * (1 - 1e-6)), {})(0, 0) > 1e4);
    const Mat<2> plane = Vec<2>(limit * limit, 1).asDiagonal();
    CHECK_FALSE(law.admissible<2>(plane));
    CHECK(law.admissible<2>(Mat<2>(0.99 * plane)));
}
