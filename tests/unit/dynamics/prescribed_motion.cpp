// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/stepper.h"
#include "../scene/values.h"
#include "dynamics/solid/derived_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <limits>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// `part`: and what is to be said besides. Displacements are expressions of t, x, y and z.
std::string moved(const std::string& part, const std::vector<std::string>& displacement) {
    return fmt::format("type: constraint.prescribed_motion, part: {}, displacement: ['{}']", part,
                       fmt::join(displacement, "', '"));
}

}  // namespace

TEST_CASE("an elastic part is where its motion says after every step") {
    Scene<2> scene;
    Body<2>& body = scene.elastic("block", scene.lattice(6, 0.1));
    const Part<2> left =
        scene.part(body, "left", [](const Vec<2>& R) { return R[0] < 2 * spacing; });
    Stepper<2> stepper(scene, body);
    const auto& R = body.particles.vector(fields::initial_position);
    const auto& r = body.particles.position();
    const auto u = [&](const Vec<2>& X, double t) -> Vec<2> {
        return {0.02 * std::sin(30 * t), 0.5 * t * X[0]};
    };
    const std::vector<std::string> texts{"0.02*sin(30*t)", "0.5*t*x"};
    const bool only_y = GENERATE(false, true);
    const auto motion =
        scene.method(moved(only_y ? "block.left, directions: [y]" : "block.left", texts));
    double other = 0;  // motion of the particles that are free, or along the free axis
    for (int k = 0; k < 200; ++k) {
        const double begin = stepper.clock.time;
        stepper.step(scene.random(0.5e-3, 2e-3), {}, {&motion});
        const double end = stepper.clock.time;
        for (std::size_t n = 0; n < left.size(); ++n) {
            const std::size_t i = left[n];
            const Vec<2> expected = R[i] + u(R[i], end);
            const Vec<2> v = (u(R[i], end) - u(R[i], begin)) / (end - begin);
            for (int c = only_y ? 1 : 0; c < 2; ++c) {
                CHECK(std::abs(r[i][c] - expected[c]) <= 4 * epsilon);
                CHECK(body.particles.vector(fields::velocity)[i][c] == Approx(v[c]).epsilon(1e-9));
            }
            if (only_y) other = std::max(other, std::abs(r[i][0] - R[i][0]));
        }
    }
    for (std::size_t i = 0; i < body.size(); ++i) {
        CHECK(r[i].allFinite());
        if (R[i][0] > 4 * spacing) other = std::max(other, (r[i] - R[i]).norm());
    }
    CHECK(other > 1e-3);
}

TEST_CASE("what moves a body as a whole gives its mass times its acceleration") {
    Scene<3> scene;
    Body<3>& body = scene.elastic("block", scene.lattice(4, 0.1));
    Stepper<3> stepper(scene, body);
    const auto motion = scene.method(moved("block", {"1.5*t^2", "0", "-2*t^2"}));
    const double mass = massOf(body);
    for (int k = 0; k < 20; ++k) {
        stepper.step(1e-3, {}, {&motion});
        if (k > 0) CHECK((motion.load().force - mass * Vec<3>(3, 0, -4)).norm() < 1e-9 * mass);
    }
    CHECK(&motion.as<KnownLoad<3>>().loaded() == &body);
}

TEST_CASE("the stress of a block that is stretched") {
    Scene<3> scene;
    Body<3>& body = scene.elastic("block", scene.lattice(4, 0.1));
    const auto& stress = body.particles.matrix(fields::piola_kirchhoff_stress);
    const auto& energy = body.particles.scalar(fields::strain_energy_density);
    Stepper<3> stepper(scene, body);
    // Velocities are those of the middle of a step: F is complete once the motion has stopped.
    const auto motion =
        scene.method(moved("block", {"0.3*(t < 1 ? t : 1)*x", "-0.1*(t < 1 ? t : 1)*y", "0"}));
    for (int k = 0; k < 102; ++k) stepper.step(1e-2, {}, {&motion});
    solid::derive(body, fields::piola_kirchhoff_stress);
    solid::derive(body, fields::strain_energy_density);

    // S = lambda tr(E) I + 2 mu E with the stretches 1.3, 0.9 and 1, P = F S.
    const double mu = youngs_modulus / (2 * 1.3);
    const double lambda = youngs_modulus * 0.3 / (1.3 * 0.4);
    const Vec<3> stretch(1.3, 0.9, 1);
    const Vec<3> strain((1.69 - 1) / 2, (0.81 - 1) / 2, 0);
    const Mat<3> P = stretch.cwiseProduct(2 * mu * strain + Vec<3>::Constant(lambda * strain.sum()))
                         .asDiagonal();
    const double W = lambda / 2 * strain.sum() * strain.sum() + mu * strain.squaredNorm();
    for (std::size_t i = 0; i < body.size(); ++i) {
        CHECK((stress[i] - P).norm() < 1e-10 * youngs_modulus);
        CHECK(energy[i] == Approx(W).epsilon(1e-10));
    }
    // What the motion takes to hold the block adds up to nothing.
    CHECK(motion.load().force.norm() < 1e-10 * youngs_modulus * spacing * spacing);
}

TEST_CASE("a wall that moves: what a fluid sees of it") {
    Scene<2> scene;
    scene.repeat(0, Vec<2>(0, -10), Vec<2>(1, 10));
    Body<2>& wall = scene.wall("wall", scene.lattice({10, 3}));
    wall.particles.vector(fields::velocity)[0] = {7, 8};
    const auto& R = wall.particles.vector(fields::initial_position);
    const Clock clock{0.5, 0.25, 0};
    const std::vector<std::string> texts{"3*t + 2*t^2 + y", "-t^2*x"};

    SECTION("position at the end of the step, velocity and acceleration of its middle") {
        const auto motion = scene.method(moved("wall", texts));
        const auto version = wall.version;
        motion.run(clock);
        CHECK(wall.version > version);
        for (std::size_t i = 0; i < wall.size(); ++i) {
            const double x = R[i][0] + 3 * 0.75 + 2 * 0.75 * 0.75 + R[i][1];
            CHECK(wall.particles.position()[i][0] == Approx(x - std::floor(x)).margin(4 * epsilon));
            CHECK(wall.particles.position()[i][1] ==
                  Approx(R[i][1] - 0.75 * 0.75 * R[i][0]).margin(4 * epsilon));
            const Vec<2> v(3 + 4 * 0.625, -2 * 0.625 * R[i][0]);
            const Vec<2> a(4, -2 * R[i][0]);
            CHECK((wall.particles.vector(fields::velocity)[i] - v).norm() < 1e-13);
            CHECK((wall.particles.vector(fields::acceleration)[i] - a).norm() < 1e-12);
        }
        motion->rest();
        for (std::size_t i = 0; i < wall.size(); ++i) {
            CHECK(wall.particles.vector(fields::velocity)[i].norm() == 0);
            CHECK(wall.particles.vector(fields::acceleration)[i].norm() == 0);
        }
    }
    SECTION("a part, along one axis") {
        scene.part(wall, "end", [](const Vec<2>& x) { return x[0] > 0.5; });
        const auto motion = scene.method(moved("wall.end, directions: [y]", texts));
        motion.run(clock);
        wall.particles.vector(fields::velocity).data()[wall.size() - 1][0] = 9;
        motion->rest();
        CHECK(wall.particles.vector(fields::velocity)[0] == Vec<2>(7, 8));
        CHECK(wall.particles.vector(fields::velocity)[wall.size() - 1] == Vec<2>(9, 0));
        for (std::size_t i = 0; i < wall.size(); ++i) {
            CHECK(wall.particles.position()[i][0] == R[i][0]);
            const double y = R[i][0] > 0.5 ? R[i][1] - 0.75 * 0.75 * R[i][0] : R[i][1];
            CHECK(wall.particles.position()[i][1] == Approx(y).margin(4 * epsilon));
        }
    }
}

namespace {

/// A wall whose normals all have one direction.
template <int Dim>
Body<Dim>& wallWithNormals(Scene<Dim>& scene, const Vec<Dim>& normal) {
    Body<Dim>& wall = scene.wall("wall", scene.lattice(4));
    for (const particles::FieldInfo* field : {&fields::normal, &fields::initial_normal})
        give(wall, *field, [&](const Vec<Dim>&) { return normal; });
    return wall;
}

template <int Dim>
void runTo(Scene<Dim>& scene, const std::string& motion, double time) {
    const auto method = scene.method(motion);
    method->prepare();
    method.run({time - 0.01, 0.01, 0});
}

}  // namespace

TEST_CASE("a wall turns and shifts as a whole, and its normals with it") {
    Scene<2> scene;
    const Vec<2> n(0.6, 0.8);
    Body<2>& wall = wallWithNormals<2>(scene, n);
    runTo(scene,
          "type: constraint.prescribed_motion, part: wall, translation: [t, 2*t], "
          "rotation: {about: [0.3, -0.1], angle: 0.5*t^2}",
          1);
    Mat<2> turn;
    turn << std::cos(0.5), -std::sin(0.5), std::sin(0.5), std::cos(0.5);
    const Vec<2> about(0.3, -0.1);
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const Vec<2>& R = wall.particles.vector(fields::initial_position)[i];
        const Vec<2> r = about + turn * (R - about) + Vec<2>(1, 2);
        CHECK((wall.particles.position()[i] - r).norm() < 4 * epsilon);
        CHECK((wall.particles.vector(fields::normal)[i] - turn * n).norm() < 4 * epsilon);
        // Over a step of 0.01 at its middle, t = 0.995, where the angular speed is t.
        const Vec<2> arm = r - Vec<2>(1, 2) - about;
        const Vec<2> v = Vec<2>(1, 2) + Vec<2>(-arm[1], arm[0]);
        CHECK((wall.particles.vector(fields::velocity)[i] - v).norm() < 0.02);
    }
}

TEST_CASE("a turn that is written out as a displacement turns the normals as well") {
    Scene<2> scene;
    const Vec<2> n(0.6, 0.8);
    Body<2>& wall = wallWithNormals<2>(scene, n);
    const std::vector<std::string> turn{"x*cos(t) - y*sin(t) - x", "x*sin(t) + y*cos(t) - y"};
    runTo(scene, moved("wall", turn), 0.7);
    const Vec<2> expected(std::cos(0.7) * n[0] - std::sin(0.7) * n[1],
                          std::sin(0.7) * n[0] + std::cos(0.7) * n[1]);
    for (std::size_t i = 0; i < wall.size(); ++i)
        CHECK((wall.particles.vector(fields::normal)[i] - expected).norm() < 1e-11);
}

TEST_CASE("normals of a wall that shears stay perpendicular to its surface") {
    Scene<2> scene;
    Body<2>& wall = wallWithNormals<2>(scene, Vec<2>(1, 0));
    // The surface x = const leans by the angle atan(0.5 t).
    runTo(scene, moved("wall", {"0.5*t*y", "0"}), 2);
    for (std::size_t i = 0; i < wall.size(); ++i)
        CHECK((wall.particles.vector(fields::normal)[i] - Vec<2>(1, -1).normalized()).norm() <
              1e-11);
}

TEST_CASE("in space a wall turns about an axis") {
    Scene<3> scene;
    Body<3>& wall = wallWithNormals<3>(scene, Vec<3>(1, 0, 0));
    // A third of a turn.
    runTo(scene,
          "type: constraint.prescribed_motion, part: wall, "
          "rotation: {about: [0, 0, 0], axis: [1, 1, 1], angle: 2.09439510239319549*t}",
          1);
    for (std::size_t i = 0; i < wall.size(); ++i) {  // x becomes y, y becomes z, z becomes x
        const Vec<3>& R = wall.particles.vector(fields::initial_position)[i];
        CHECK((wall.particles.position()[i] - Vec<3>(R[2], R[0], R[1])).norm() < 4 * epsilon);
        CHECK((wall.particles.vector(fields::normal)[i] - Vec<3>(0, 1, 0)).norm() < 4 * epsilon);
    }
}

TEST_CASE("a wall that only shifts keeps its normals to the bit") {
    Scene<2> scene;
    const Vec<2> n = Vec<2>(1, 3).normalized();
    Body<2>& wall = wallWithNormals<2>(scene, n);
    runTo(scene, moved("wall", {"3*t", "t^2"}), 1);
    for (std::size_t i = 0; i < wall.size(); ++i)
        CHECK(wall.particles.vector(fields::normal)[i] == n);
}

TEST_CASE("along an axis on which a wall does not move its normals do not turn either") {
    Scene<2> scene;
    Body<2>& wall = wallWithNormals<2>(scene, Vec<2>(1, 0));
    runTo(scene, moved("wall, directions: [y]", {"0.5*t*y", "t"}), 2);
    for (std::size_t i = 0; i < wall.size(); ++i)
        CHECK((wall.particles.vector(fields::normal)[i] - Vec<2>(1, 0)).norm() < 1e-14);
}
