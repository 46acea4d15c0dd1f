// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "support.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::materials;

namespace {

Stiffness isotropicTensor(double lambda, double mu) {
    Stiffness tensor = Stiffness::Zero();
    tensor.topLeftCorner<3, 3>().setConstant(lambda);
    tensor.diagonal().head<3>().array() += 2 * mu;
    tensor.diagonal().tail<3>().setConstant(mu);
    return tensor;
}

LinearElasticParameters parametersOf(const Stiffness& tensor) {
    LinearElasticParameters p;
    p.density = 1;
    p.stiffness.assign(6, std::vector<double>(6));
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            p.stiffness[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = tensor(i, j);
    return p;
}

}  // namespace

TEST_CASE("each pair of elastic constants gives the same solid") {
    const IsotropicParameters young = isotropicParameters();
    IsotropicParameters bulk;
    bulk.bulk_modulus = 1 / (3 * (1 - 2 * 0.3));
    bulk.shear_modulus = 1 / (2 * (1 + 0.3));
    IsotropicParameters lame;
    lame.lame_lambda = 0.5769230769230769;
    lame.lame_mu = 0.3846153846153846;
    for (const IsotropicParameters& p : {young, bulk, lame}) {
        CHECK(p.violation().empty());
        CHECK(p.lambda() == Approx(0.5769230769230769).epsilon(1e-14));
        CHECK(p.mu() == Approx(0.3846153846153846).epsilon(1e-14));
    }
}

TEST_CASE("the orthotropic tensor answers stresses by the engineering strains") {
    LinearElasticParameters p = orthotropicParameters();
    p.axis_1 = p.axis_2 = {};
    REQUIRE(p.constantsViolation().empty());
    const double e1 = *p.youngs_modulus_1;
    const double e2 = *p.youngs_modulus_2;
    Stiffness compliance = Stiffness::Zero();
    compliance.diagonal() << 1 / e1, 1 / e2, 1 / *p.youngs_modulus_3, 1 / *p.shear_modulus_23,
        1 / *p.shear_modulus_13, 1 / *p.shear_modulus_12;
    compliance(0, 1) = compliance(1, 0) = -*p.poisson_ratio_12 / e1;
    compliance(0, 2) = compliance(2, 0) = -*p.poisson_ratio_13 / e1;
    compliance(1, 2) = compliance(2, 1) = -*p.poisson_ratio_23 / e2;
    CHECK((p.tensor() * compliance - Stiffness::Identity()).norm() <= 1e-14);
}

TEST_CASE("an isotropic tensor is the Kirchhoff law, however its axes are turned") {
    const SaintVenantKirchhoff kirchhoff(isotropicParameters());
    LinearElasticParameters p = parametersOf(isotropicTensor(kirchhoff.lambda(), kirchhoff.mu()));
    p.axis_1 = {{1, 2, -0.5}, 3};
    p.axis_2 = {{-2, 1, 0}, 3};
    REQUIRE(p.constantsViolation().empty());
    REQUIRE(p.axesViolation().empty());
    const LinearElastic law(p);
    Random random(8);
    for (int trial = 0; trial < 20; ++trial) {
        const Mat<3> F = Mat<3>::Identity() + random.matrix<3>(0.3);
        const Mat<3> C = rightCauchyGreen<3>(F);
        CHECK((law.stress<3>(C, {}) - kirchhoff.stress<3>(C, {})).norm() <= 1e-14);
        CHECK(law.energy<3>(C, {}) == Approx(kirchhoff.energy<3>(C, {})).epsilon(1e-13));
    }
    CHECK(law.bulkModulus() == Approx(kirchhoff.bulkModulus()));
    CHECK(law.shearModulus() == Approx(kirchhoff.shearModulus()));
    CHECK(law.longitudinalModulus() == Approx(kirchhoff.longitudinalModulus()));
}

TEST_CASE("turned axes give the turned stress of the turned strain") {
    LinearElasticParameters straight = orthotropicParameters();
    straight.axis_1 = straight.axis_2 = {};
    const LinearElastic law(straight);
    const LinearElastic turned(orthotropicParameters());
    Mat<3> axes;
    axes.col(0) = Vec<3>(1, 2, 0.5).normalized();
    axes.col(1) = Vec<3>(-2, 1, 0).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    Random random(9);
    for (int trial = 0; trial < 20; ++trial) {
        const Mat<3> F = Mat<3>::Identity() + random.matrix<3>(0.3);
        const Mat<3> C = rightCauchyGreen<3>(F);
        const Mat<3> turned_back = axes.transpose() * C * axes;
        const Mat<3> local = (turned_back + turned_back.transpose()) / 2;
        const Mat<3> expected = axes * law.stress<3>(local, {}) * axes.transpose();
        CHECK((turned.stress<3>(C, {}) - expected).norm() <= 1e-14);
    }
    CHECK(turned.longitudinalModulus() == Approx(law.longitudinalModulus()).epsilon(1e-12));
    CHECK(turned.shearModulus() == Approx(law.shearModulus()).epsilon(1e-12));
}

TEST_CASE("in the plane axis 1 may be given alone") {
    LinearElasticParameters p = orthotropicParameters();
    p.axis_1 = {{0, 1, 0}, 2};
    p.axis_2 = {};
    REQUIRE(p.axesViolation().empty());
    const LinearElastic law(p);
    p.axis_1 = {};
    const LinearElastic straight(p);
    CHECK(law.stiffness()(1, 1) == Approx(straight.stiffness()(0, 0)));
    CHECK(law.stiffness()(0, 0) == Approx(straight.stiffness()(1, 1)));
    CHECK(law.stiffness()(5, 5) == Approx(straight.stiffness()(5, 5)));
    CHECK(law.stiffness()(2, 1) == Approx(straight.stiffness()(2, 0)));
}

TEST_CASE("directions of a muscle are made unit and perpendicular") {
    HolzapfelMuscleParameters p = muscleParameters();
    const auto set = [](std::vector<input::FieldExpression>& to, std::vector<double> from) {
        to.clear();
        for (const double component : from) to.emplace_back(component);
    };
    Fibres<3> d;
    set(p.fibre, {3, 4, 0});
    set(p.sheet, {-4.001, 3, 0});
    REQUIRE_FALSE(p.directions<3>(Vec<3>::Zero(), d));
    CHECK((d.fibre - Vec<3>(0.6, 0.8, 0)).norm() <= 1e-15);
    CHECK((d.sheet - Vec<3>(-0.8, 0.6, 0)).norm() <= 1e-15);
    set(p.sheet, {-4.1, 3, 0});
    CHECK(p.directions<3>(Vec<3>::Zero(), d)->parameter == "sheet");

    Fibres<2> plane;
    set(p.fibre, {0, -2});
    p.sheet.clear();
    REQUIRE_FALSE(p.directions<2>(Vec<2>::Zero(), plane));
    CHECK(plane.fibre == Vec<2>(0, -1));
    CHECK(plane.sheet == Vec<2>(1, 0));
    set(p.fibre, {0, 0});
    CHECK(p.directions<2>(Vec<2>::Zero(), plane)->parameter == "fibre");
}
