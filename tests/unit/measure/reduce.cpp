// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "entry.h"
#include "measure/reduce_motion.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::measure;
using namespace sphinx::test;

namespace {

/// A block of 1 x 1 (x 1) with density 2, so of mass 2.
template <int Dim>
struct Block : Scene<Dim> {
    bodies::Body<Dim>& water = this->fluid("water", this->box(Vec<Dim>::Zero(), Vec<Dim>::Ones()));
    ReducedBody<Dim> reduced{{&water}, {}, {}};
    particles::Field<Vec<Dim>>& x = water.particles.position();
    particles::Field<Vec<Dim>>& v = water.particles.vector(fields::velocity);
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("energies of a block that falls", "", ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    block.water.fluid().gravity[Dim - 1] = -9;
    for (std::size_t i = 0; i < block.water.size(); ++i) block.v[i][Dim - 1] = -3;
    std::vector<double> row = rowOf(*mechanicalEnergy(block.reduced));
    CHECK(row[0] == Approx(0.5 * 2 * 9));  // m v^2/2
    CHECK(row[1] == Approx(2 * 9 * 0.5));  // m g times the height of the centre
    CHECK(row[2] == 0);                    // at the reference density
    CHECK(row[3] == Approx(row[0] + row[1]));
    CHECK(rowOf(*kineticEnergy(block.reduced))[0] == row[0]);

    // Compressed by 1 %: m c^2 (ln x + 1/x - 1) = m c^2 (x - 1)^2/2 to first order.
    for (std::size_t i = 0; i < block.water.size(); ++i)
        block.water.particles.scalar(fields::density)[i] = 2.02;
    row = rowOf(*mechanicalEnergy(block.reduced));
    CHECK(row[2] == Approx(2 * 100 * 0.5e-4).epsilon(0.02));
    CHECK(row[3] == Approx(row[0] + row[1] + row[2]));
}

TEMPLATE_TEST_CASE_SIG("momentum of a block that moves", "", ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    Vec<Dim> velocity = Vec<Dim>::LinSpaced(Dim, 1, Dim);
    for (std::size_t i = 0; i < block.water.size(); ++i) block.v[i] = velocity;
    const std::vector<double> row = rowOf(*momentum(block.reduced));
    REQUIRE(row.size() == Dim);
    for (int k = 0; k < Dim; ++k) CHECK(row[k] == Approx(2 * velocity[k]));
    const std::vector<double> angular = rowOf(*angularMomentum(block.reduced));
    const double m = 2;
    const double c = 0.5;  // the centre
    if constexpr (Dim == 2) {
        REQUIRE(angular.size() == 1);
        CHECK(angular[0] == Approx(m * c * (2 - 1)));
    } else {
        REQUIRE(angular.size() == 3);
        CHECK(angular[0] == Approx(m * c * (3 - 2)));
        CHECK(angular[1] == Approx(m * c * (1 - 3)));
        CHECK(angular[2] == Approx(m * c * (2 - 1)));
    }
}

TEST_CASE("angular momentum of a disc that turns, about each axis") {
    Block<3> block;
    const Vec<3> omega(0.3, -0.2, 0.7);
    Mat<3> inertia = Mat<3>::Zero();
    for (std::size_t i = 0; i < block.water.size(); ++i) {
        block.v[i] = omega.cross(block.x[i]);
        const Vec<3>& x = block.x[i];
        inertia += block.water.particles.scalar(fields::mass)[i] *
                   (x.squaredNorm() * Mat<3>::Identity() - x * x.transpose());
    }
    const Vec<3> expected = inertia * omega;
    const std::vector<double> row = rowOf(*angularMomentum(block.reduced));
    for (int k = 0; k < 3; ++k) CHECK(row[k] == Approx(expected[k]));
}

TEST_CASE("mass, particles and how many have left") {
    Block<2> block;
    block.water.particles.remove({0, 5, 7});
    const std::vector<double> row = rowOf(*mass(block.reduced));
    CHECK(row[0] == Approx(2 * 0.97));
    CHECK(row[1] == 97);
    CHECK(row[2] == 3);
}

TEST_CASE("extremes of a body, and of one without particles") {
    Block<2> block;
    block.v[17] = Vec<2>(-3, 4);
    CHECK(rowOf(*maximumSpeed(block.reduced))[0] == 5);
    CHECK(rowOf(*frontPosition(block.reduced, 0))[0] == Approx(0.95));
    for (std::size_t i = 0; i < block.water.size(); ++i) block.x[i][1] -= 10;
    CHECK(rowOf(*frontPosition(block.reduced, 1))[0] == Approx(-9.05));
    std::vector<Index> all(block.water.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
    block.water.particles.remove(all);
    CHECK(std::isnan(rowOf(*maximumSpeed(block.reduced))[0]));
    CHECK(std::isnan(rowOf(*frontPosition(block.reduced, 0))[0]));
    CHECK(rowOf(*kineticEnergy(block.reduced))[0] == 0);
}

TEST_CASE("sums do not depend on the number of threads") {
    Scene<2> scene;
    scene.spacing = 0.01;
    bodies::Body<2>& water = scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    water.fluid().gravity = Vec<2>(0.1, -9);
    for (std::size_t i = 0; i < water.size(); ++i)
        water.particles.vector(fields::velocity)[i] = Vec<2>(std::sin(1.0 * i), std::cos(3.0 * i));
    const auto source = mechanicalEnergy(ReducedBody<2>{&water, {}, {}});
    setThreadCount(1);
    const std::vector<double> one = rowOf(*source);
    setThreadCount(3);
    CHECK(rowOf(*source) == one);
    setThreadCount(0);
}

TEST_CASE("reductions of a case are named and checked") {
    TemporaryFolder folder;
    Scene<2> scene;
    scene.fluid("water", scene.box(Vec<2>(0, 0), Vec<2>(1, 1)));
    scene.add("wall", bodies::WallRole{});  // a body without fields
    const auto header = [&](const std::string& quantity) {
        Entry("{type: reduce, body: water, quantity: " + quantity + "}")
            .make(outputContext(scene, folder.path()))
            ->write(clockAt(0));
        const std::string text = readFile(folder / "row.csv", 10000);
        std::filesystem::remove(folder / "row.csv");
        return text.substr(0, text.find('\n'));
    };
    CHECK(header("mechanical_energy") ==
          "time [s],kinetic [J],potential [J],internal [J],total [J]");
    CHECK(header("kinetic_energy") == "time [s],kinetic [J]");
    CHECK(header("mass") == "time [s],mass [kg],particles,removed");
    CHECK(header("momentum") == "time [s],momentum_x [kg*m/s],momentum_y [kg*m/s]");
    CHECK(header("angular_momentum") == "time [s],angular_momentum [kg*m^2/s]");
    CHECK(header("maximum_speed") == "time [s],maximum_speed [m/s]");
    CHECK(header("front_position") == "time [s],front_position [m]");

    const auto error = [&](const std::string& yaml) {
        return errorOf([&] { Entry(yaml).make(outputContext(scene, folder.path())); });
    };
    using Catch::StartsWith;
    CHECK_THAT(
        error("{type: reduce, body: wall, quantity: mechanical_energy}"),
        StartsWith("case.yaml:1:22: error: 'wall' is rigid: it has no internal energy; ask for "
                   "kinetic_energy"));
    CHECK_THAT(error("{type: reduce, body: wall, quantity: kinetic_energy}"),
               StartsWith("case.yaml:1:22: error: 'wall' has no field 'velocity' in this case"));
    CHECK_THAT(error("{type: reduce, body: water, quantity: front_position, axis: z}"),
               StartsWith("case.yaml:1:61: error: a case in 2D has no axis z"));
    CHECK_THAT(error("{type: reduce, body: water, quantity: mass, axis: x}"),
               StartsWith("case.yaml:1:51: error: 'axis' is for front_position"));
    CHECK_THAT(error("{type: reduce, body: water, quantity: force}"),
               StartsWith("case.yaml:1:22: error: the force is that of fluids on a solid, but "
                          "'water' is a fluid"));
    CHECK_THAT(error("{type: reduce, body: wall, quantity: force}"),
               StartsWith("case.yaml:1:22: error: there is no force on 'wall' to be summed: no "
                          "fluid that the loop moves sees it"));
}

TEST_CASE("sums over a part are those of its particles") {
    Block<2> block;
    for (std::size_t i = 0; i < block.water.size(); ++i) block.v[i] = Vec<2>(block.x[i][0], 1);
    const auto part = block.part(block.water, "left", [](const Vec<2>& r) { return r[0] < 0.5; });
    ReducedBody<2> left = block.reduced;
    left.part = part.named();
    REQUIRE(left.size() == block.water.size() / 2);
    CHECK(rowOf(*mass(left))[0] == Approx(1));
    CHECK(rowOf(*mass(left))[1] == 50);
    CHECK(rowOf(*mass(left)).size() == 2);
    CHECK(rowOf(*momentum(left))[0] == Approx(0.25));
    CHECK(rowOf(*momentum(left))[1] == Approx(1));
    CHECK(rowOf(*frontPosition(left, 0))[0] == Approx(0.45));
    CHECK(rowOf(*maximumSpeed(left))[0] == Approx(std::hypot(0.45, 1)));
    CHECK(rowOf(*kineticEnergy(left))[0] < rowOf(*kineticEnergy(block.reduced))[0] / 2);
    CHECK(rowOf(*mechanicalEnergy(left))[0] == rowOf(*kineticEnergy(left))[0]);
}
