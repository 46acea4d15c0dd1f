// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"
#include "../scene/values.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/terms/conformation.h"
#include "dynamics/fluid/velocity_gradient.h"
#include "materials/generalised_newtonian.h"
#include "materials/oldroyd_b_fluid.h"

#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>
#include <cmath>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

/// Fluid that sees itself, of another material than that of Bodies::fluid().
template <int Dim>
Body<Dim>& makeFluid(Scene<Dim>& scene, std::shared_ptr<const materials::Fluid> material,
                     const std::vector<Vec<Dim>>& points) {
    Body<Dim>& water = scene.add("water", bodies::FluidRole<Dim>{std::move(material)});
    water.sees = {&water};
    return scene.place(water, points);
}

template <int Dim>
Mat<Dim> someMatrix() {
    Mat<Dim> m;
    for (int a = 0; a < Dim; ++a)
        for (int b = 0; b < Dim; ++b) m(a, b) = std::sin(1 + 3 * a + 2 * b);
    return m;
}
template <int Dim>
Mat<Dim> rotation(double angle) {
    Mat<Dim> R = Mat<Dim>::Identity();
    R(0, 0) = R(1, 1) = std::cos(angle);
    R(1, 0) = std::sin(angle);
    R(0, 1) = -R(1, 0);
    return R;
}
template <int Dim>
Mat<Dim> spin(double rate) {
    Mat<Dim> L = Mat<Dim>::Zero();
    L(1, 0) = rate;
    L(0, 1) = -rate;
    return L;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the velocity gradient of a linear field is exact", "", ((int Dim), Dim), 2,
                       3) {
    Scene<Dim> scene;
    const Precision precision = GENERATE(Precision::full, Precision::single);
    scene.world.precision = precision;
    Body<Dim>& water = scene.fluid("water", scene.lattice(9, 0.2));
    const Mat<Dim> L = someMatrix<Dim>();
    give(water, fields::velocity, [&](const Vec<Dim>& x) -> Vec<Dim> { return L * x; });
    fluid::VelocityGradient<Dim> found(scene.context, water, true);
    scene.relations.update({&water});
    found.find();
    // At the surface as well.
    for (std::size_t i = 0; i < water.size(); ++i) CHECK((found.gradient()[i] - L).norm() < 1e-4);
}

TEST_CASE("at a wall the velocity gradient is that of the flow along it") {
    Scene<2> scene;
    Body<2>& water = scene.fluid("water", scene.box({0, 0}, {1.2, 0.6}));
    Body<2>& wall = scene.wall("wall", scene.box({-0.4, -0.4}, {1.6, 0}), Face{1, 0, 1});
    water.sees = {&water, &wall};
    const Vec<2> moving(0.3, 0);
    give(wall, fields::velocity, [&](const Vec<2>&) -> Vec<2> { return moving; });
    give(water, fields::velocity,
         [&](const Vec<2>& x) -> Vec<2> { return moving + Vec<2>(2 * x[1], 0); });
    fluid::VelocityGradient<2> found(scene.context, water, true);
    scene.relations.update({&water});
    found.find();
    Mat<2> L = Mat<2>::Zero();
    L(0, 1) = 2;
    for (std::size_t i = 0; i < water.size(); ++i) CHECK((found.gradient()[i] - L).norm() < 1e-3);
}

TEST_CASE("a lone particle has no velocity gradient") {
    Scene<2> scene;
    Body<2>& water = scene.fluid("water", {Vec<2>(0, 0), Vec<2>(0.1, 0), Vec<2>(3, 3)});
    give(water, fields::velocity, [](const Vec<2>& x) -> Vec<2> { return x; });
    fluid::VelocityGradient<2> found(scene.context, water, true);
    scene.relations.update({&water});
    found.find();
    for (const Mat<2>& L : found.gradient()) CHECK(L.isZero(0));
    for (const Mat<2>& B : found.correction()) CHECK(B.isZero(0));
}

TEST_CASE("where the viscosity varies the force is div(2 mu D), not div(mu grad v)") {
    // v = (y^2, x^2): gamma = 2 (x + y), and div(2 mu D) = 2 n k gamma^(n - 1) (1, 1).
    const double n = GENERATE(0.5, 1.5);
    const double k = 0.7;
    Scene<2> scene;
    scene.world.precision = Precision::full;
    const double fine = 0.02;
    scene.spacing = fine;
    std::vector<Vec<2>> points;
    for (int j = 0; j <= 24; ++j)
        for (int i = 0; i <= 24; ++i) points.push_back(Vec<2>(1 + fine * i, 0.5 + fine * j));
    Body<2>& water =
        makeFluid<2>(scene,
                     std::make_shared<materials::PowerLawFluid>(
                         materials::PowerLawParameters{density, sound_speed, k, n, 1, 1e-6}),
                     points);
    give(water, fields::velocity, [](const Vec<2>& x) -> Vec<2> {
        return {x[1] * x[1], x[0] * x[0]};
    });
    const auto force = scene.method("type: fluid.viscous_force, body: water");
    scene.relations.update({&water});
    force.run({});
    const std::size_t middle = points.size() / 2;
    const Vec<2>& x = points[middle];
    const double gamma = 2 * (x[0] + x[1]);
    const double mu = k * std::pow(gamma, n - 1);
    CHECK(water.particles.scalar(fields::shear_rate)[middle] == Approx(gamma).epsilon(1e-3));
    CHECK(water.particles.scalar(fields::viscosity)[middle] == Approx(mu).epsilon(1e-3));
    const Vec<2>& a = water.particles.vector(fields::external_acceleration)[middle];
    for (int c = 0; c < 2; ++c) CHECK(a[c] == Approx(2 * n * mu / density).epsilon(2e-3));
    // div(mu grad v) alone is 2 mu + (n - 1) mu 2 y/(x + y) along x.
    const double without = (2 * mu + (n - 1) * mu * 2 * x[1] / (x[0] + x[1])) / density;
    CHECK(std::abs(a[0] / without - 1) > 0.1);
}

TEST_CASE("the step follows the largest viscosity that is there") {
    Scene<2> scene;
    const double k = 40;
    Body<2>& water =
        makeFluid<2>(scene,
                     std::make_shared<materials::PowerLawFluid>(
                         materials::PowerLawParameters{density, sound_speed, k, 1.5, 1, 1e-6}),
                     scene.lattice(12));
    const auto force = scene.method("type: fluid.viscous_force, body: water");
    force->announce();
    const auto step = scene.timeStep(
        "type: fluid.advection_time_step, body: water, reference_speed: 0.01, cfl: 0.1");
    const double h = water.kernel.smoothingLength();
    const auto limit = [&](double rate) { return 0.1 * h * h * density / (k * std::sqrt(rate)); };
    // Before the force has acted: at a shear of the reference speed over h.
    CHECK(step->estimate() == Approx(limit(0.01 / h)).epsilon(1e-6));
    give(water, fields::velocity, [](const Vec<2>& x) -> Vec<2> { return {1e-3 * x[1], 0}; });
    scene.relations.update({&water});
    force.run({});
    CHECK(step->estimate() == Approx(limit(1e-3)).epsilon(1e-3));
}

TEMPLATE_TEST_CASE_SIG("polymers turn with a fluid that turns, at any step", "", ((int Dim), Dim),
                       2, 3) {
    const Mat<Dim> F = Mat<Dim>::Identity() + 0.3 * someMatrix<Dim>();
    Mat<Dim> c = F * F.transpose();
    const Mat<Dim> before = c;
    // Nothing relaxes: the same eigenvalues after ten steps of a radian or so.
    for (int step = 0; step < 10; ++step)
        c = fluid::relaxedConformation<Dim>(c, spin<Dim>(1.1), 1, 1e30);
    const double angle = 10 * 2 * std::atan(0.55);
    const Mat<Dim> R = rotation<Dim>(angle);
    CHECK((c - R * before * R.transpose()).norm() < 1e-13);
    // At rest polymers stay at rest, whatever their time.
    for (const double lambda : {0.01, 1.0, 100.0})
        CHECK((fluid::relaxedConformation<Dim>(Mat<Dim>::Identity(), spin<Dim>(1.1), 1, lambda) -
               Mat<Dim>::Identity())
                  .norm() < 1e-14);
}

TEMPLATE_TEST_CASE_SIG("the law is the same in a frame that turns", "", ((int Dim), Dim), 2, 3) {
    // A shear flow seen from a frame that turns: L = R (G - W) R^T + ..., by small steps.
    const double rate = 2, turn = 1.3, lambda = 0.7;
    Mat<Dim> G = Mat<Dim>::Zero();
    G(0, 1) = rate;
    const auto final = [&](int steps) {
        const double dt = 1.0 / steps;
        Mat<Dim> still = Mat<Dim>::Identity(), turned = Mat<Dim>::Identity();
        for (int k = 0; k < steps; ++k) {
            const Mat<Dim> R = rotation<Dim>(turn * (k + 0.5) * dt);
            still = fluid::relaxedConformation<Dim>(still, G, dt, lambda);
            turned = fluid::relaxedConformation<Dim>(
                turned, R * G * R.transpose() + spin<Dim>(turn), dt, lambda);
        }
        const Mat<Dim> R = rotation<Dim>(turn);
        return (turned - R * still * R.transpose()).norm();
    };
    CHECK(final(100) < 1e-3);
    CHECK(final(200) < 0.27 * final(100));  // of second order
}

TEST_CASE("polymers in simple shear, by the closed form and at any step") {
    const double lambda = GENERATE(0.5, 5.0, 50.0);
    Mat<2> L = Mat<2>::Zero();
    L(0, 1) = 1;
    Mat<2> c = Mat<2>::Identity();
    const double dt = 0.02;
    double worst = 1;
    for (int k = 1; k <= 1000; ++k) {
        c = fluid::relaxedConformation<2>(c, L, dt, lambda);
        worst = std::min(worst, Eigen::SelfAdjointEigenSolver<Mat<2>>(c).eigenvalues()[0]);
    }
    const double t = 1000 * dt / lambda, e = std::exp(-t);
    CHECK(worst > 0);
    CHECK(c(0, 1) == Approx(lambda * (1 - e)).epsilon(1e-4));
    CHECK(c(0, 0) - 1 == Approx(2 * lambda * lambda * (1 - e - t * e)).epsilon(1e-4));
    CHECK(c(1, 1) == Approx(1).epsilon(1e-12));
    // Of steps far longer than lambda: the Newtonian stress, and positive.
    const Mat<2> quick = fluid::relaxedConformation<2>(Mat<2>::Identity(), L, 1, 1e-3);
    CHECK(quick(0, 1) == Approx(1e-3).epsilon(1e-5));
    const Mat<2> wild = fluid::relaxedConformation<2>(c, 30 * someMatrix<2>(), 1, lambda);
    CHECK(Eigen::SelfAdjointEigenSolver<Mat<2>>(wild).eigenvalues()[0] > 0);
}

namespace {

std::shared_ptr<const materials::Fluid> someOldroydB() {
    return std::make_shared<materials::OldroydBFluid>(
        materials::OldroydBParameters{density, sound_speed, 0, 0.9, 2});
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a drop with polymers that turns feels nothing, and no force is lost", "",
                       ((int Dim), Dim), 2, 3) {
    Scene<Dim> scene;
    Body<Dim>& water = makeFluid<Dim>(scene, someOldroydB(), scene.lattice(8, 0.2));
    const auto polymers = scene.method("type: fluid.polymer_stress, body: water");
    give(water, fields::velocity, [](const Vec<Dim>& x) -> Vec<Dim> { return spin<Dim>(3) * x; });
    scene.relations.update({&water});
    Clock clock;
    clock.dt = 0.1;
    polymers.run(clock);
    auto& c = water.particles.matrix(fields::conformation);
    auto& a = water.particles.vector(fields::external_acceleration);
    for (std::size_t i = 0; i < water.size(); ++i) {
        CHECK((c[i] - Mat<Dim>::Identity()).norm() < 1e-4);
        CHECK(a[i].norm() < 1e-2);
        a[i].setZero();
    }
    // Any other flow: forces, but no momentum.
    give(water, fields::velocity, [](const Vec<Dim>& x) -> Vec<Dim> {
        return Vec<Dim>::Constant(std::sin(5 * x.sum()) + x[1]);
    });
    polymers.run(clock);
    Vec<Dim> sum = Vec<Dim>::Zero();
    double size = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        sum += a[i];
        size += a[i].norm();
    }
    CHECK(size > 1);
    CHECK(sum.norm() < 1e-12 * size);
}

TEST_CASE("a wall gets what the fluid feels of its polymers, and a linear stress is exact there") {
    Scene<2> scene;
    Body<2>& water = makeFluid<2>(scene, someOldroydB(), scene.box({0, 0}, {2, 0.8}));
    Body<2>& wall = scene.wall("wall", scene.box({-0.4, -0.4}, {2.4, 0}), Face{1, 0, 1});
    water.sees = {&water, &wall};
    wall.sees = {&water};
    const auto polymers = scene.method("type: fluid.polymer_stress, body: water");
    // tau_xy = modulus (y + 1/2): its force is the modulus, in the row beside the wall as well.
    auto& c = water.particles.matrix(fields::conformation);
    for (std::size_t i = 0; i < water.size(); ++i)
        c[i](0, 1) = c[i](1, 0) = 0.5 + water.particles.position()[i][1];
    const auto& to_water = scene.relations.flow(wall, water, {.distance = true});
    scene.relations.update({&water, &wall});
    Clock clock;
    clock.dt = 1e-12;
    polymers.run(clock);
    const double modulus = 0.45;
    Vec<2> felt = Vec<2>::Zero();
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Vec<2>& x = water.particles.position()[i];
        const Vec<2>& a = water.particles.vector(fields::external_acceleration)[i];
        felt += density * spacing * spacing * a;
        if (x[1] < 0.4 && x[0] > 0.5 && x[0] < 1.5) {
            INFO("at " << x[1]);
            CHECK(a[0] == Approx(modulus / density).epsilon(0.03));
        }
    }
    Field<Vec<2>>& force = wall.particles.vector(fields::viscous_force);
    const auto& load = polymers.as<fluid::SolidLoad<2>>();
    load.addForces(wall, to_water.list, force);
    Vec<2> given = Vec<2>::Zero();
    double moment = 0;
    for (std::size_t j = 0; j < wall.size(); ++j) {
        const Vec<2>& x = wall.particles.position()[j];
        given += force[j];
        moment += x[0] * force[j][1] - x[1] * force[j][0];
    }
    CHECK((given + felt).norm() < 1e-12);
    CHECK(felt.norm() > 1e-3);
    const auto& from_water = scene.relations.flow(water, wall, {.distance = true});
    const Load<2> whole = load.loadOn(wall, from_water.list, Vec<2>::Zero());
    CHECK((whole.force - given).norm() < 1e-12);
    CHECK(whole.moment[0] == Approx(moment).margin(1e-6));
}
