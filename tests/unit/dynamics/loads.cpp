// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/stepper.h"
#include "../scene/values.h"

#include "../memory_archive.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include <numbers>
#include <optional>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double round_off = 1e-13;

/// It says what the accelerations are: their sum, and to first order in the half step that it looks
/// ahead, their moment.
template <int Dim>
void checkLoad(const MadeMethod<Dim>& method, const Body<Dim>& body) {
    const auto& acceleration = body.particles.vector(fields::external_acceleration);
    const auto& mass = body.particles.scalar(fields::mass);
    Load<Dim> given;
    for (std::size_t i = 0; i < body.size(); ++i)
        given.add(body.particles.position()[i], mass[i] * acceleration[i]);
    const Load<Dim> told = method.template as<AppliedLoad<Dim>>().load();
    CHECK((told.force - given.force).norm() < round_off * given.force.norm());
    CHECK((told.moment - given.moment).norm() < round_off * given.force.norm());
}

std::string pointForce(const std::vector<std::string>& force) {
    return fmt::format("type: force.point_force, part: block.end, force: [{}]",
                       fmt::join(force, ", "));
}
MadeMethod<2> weight(Scene<2>& scene, const Vec<2>& g) {
    return scene.method(
        fmt::format("type: force.gravity, body: block, acceleration: [{}, {}]", g[0], g[1]));
}

/// A body "block" that gravity pulls at and constraint.fix holds.
struct Held {
    Held(const std::vector<Vec<2>>& points, const Rubber& rubber, const Vec<2>& g)
        : body(scene.elastic("block", points, rubber)), gravity(weight(scene, g)) {
        scene.part(body, "top", [](const Vec<2>& R) { return R[1] > 8 * spacing; });
    }
    /// `part`: and what is to be said besides.
    void fix(const std::string& part) {
        support.emplace(scene.method("type: constraint.fix, part: " + part));
    }
    void step(double dt) { stepper.step(dt, {&gravity}, {&*support}); }

    Scene<2> scene;
    Body<2>& body;
    Stepper<2> stepper{scene, body};
    MadeMethod<2> gravity;
    std::optional<MadeMethod<2>> support;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a point force is shared without loss and moves the centre of mass", "",
                       ((int Dim), Dim), 2, 3) {
    Scene<Dim> scene;
    Body<Dim>& body = scene.elastic("block", scene.lattice(5, 0.1));
    for (std::size_t i = 0; i < body.size(); ++i)
        body.particles.scalar(fields::mass)[i] *= scene.random(0.9, 1.1);
    const Part<Dim> end =
        scene.part(body, "end", [](const Vec<Dim>& R) { return R[0] < 2 * spacing; });
    Stepper<Dim> stepper(scene, body);
    std::vector<std::string> texts{"3*cos(t)", "-2 + x"};
    if (Dim == 3) texts.push_back("1");
    const auto push = scene.method(pointForce(texts));

    SECTION("shared") {
        double place = 0;
        for (std::size_t n = 0; n < end.size(); ++n)
            place += body.particles.scalar(fields::mass)[end[n]] *
                     body.particles.position()[end[n]][0] / end.mass();
        push.run({0.3, 0.02, 0});
        const Vec<Dim> total = massTimes(body, fields::external_acceleration);
        CHECK(total[0] == Approx(3 * std::cos(0.31)).epsilon(round_off));
        CHECK(total[1] == Approx(-2 + place).epsilon(round_off));
        for (std::size_t i = 0; i < body.size(); ++i)
            if (body.particles.position()[i][0] > 2 * spacing)
                CHECK(body.particles.vector(fields::external_acceleration)[i].isZero(0));
        checkLoad(push, body);
    }
    SECTION("moves") {
        texts[0] = "3";
        texts[1] = "-2";
        const auto constant = scene.method(pointForce(texts));
        const Vec<Dim> before = centreOf(body);
        for (int k = 0; k < 200; ++k) stepper.step(1e-3, {&constant});
        const double t = stepper.clock.time;
        const Vec<Dim> moved = centreOf(body) - before;
        CHECK(moved[0] == Approx(3 * t * t / (2 * massOf(body))).epsilon(1e-11));
        CHECK(moved[1] == Approx(-2 * t * t / (2 * massOf(body))).epsilon(1e-11));
    }
}

TEST_CASE("bodies under gravity and body forces move as a point would") {
    Scene<2> scene;
    Body<2>& body = scene.elastic("block", scene.lattice(5, 0.1));
    Stepper<2> stepper(scene, body);
    const auto gravity = weight(scene, {0, -10});
    CHECK(body.gravity().isZero(0));
    gravity->announce();
    CHECK(body.gravity() == Vec<2>(0, -10));
    const Vec<2> before = centreOf(body);

    SECTION("free fall") {
        for (int k = 0; k < 100; ++k) stepper.step(1e-3, {&gravity});
        const double t = stepper.clock.time;
        CHECK((centreOf(body) - before - Vec<2>(0, -5 * t * t)).norm() < 1e-13);
    }
    SECTION("a force per mass that changes, at the middle of the step") {
        const auto body_force =
            scene.method("type: force.body_force, body: block, acceleration: [t^3, 10 + x]");
        give(body, fields::velocity, [](const Vec<2>&) { return Vec<2>(2, 0); });
        const Vec<2> x = body.particles.position()[3];
        Clock clock;
        clock.time = 1;
        clock.dt = 0.2;
        auto& external = body.particles.vector(fields::external_acceleration);
        external.setZero();
        body_force.run(clock);
        CHECK((external[3] - Vec<2>(1.1 * 1.1 * 1.1, 10 + x[0] + 0.2)).norm() < 1e-14);
        clock.is_start = true;  // there is no step yet
        external.setZero();
        body_force.run(clock);
        CHECK((external[3] - Vec<2>(1, 10 + x[0])).norm() < 1e-14);
    }
    SECTION("a force per mass of place and time, besides gravity") {
        const auto body_force =
            scene.method("type: force.body_force, body: block, acceleration: [3*y + t, x]");
        stepper.clock.time = 0.25;
        stepper.step(1e-9, {&gravity, &body_force});
        for (std::size_t i = 0; i < body.size(); ++i) {
            const Vec<2>& x = body.particles.position()[i];
            const Vec<2> expected(3 * x[1] + 0.25 + 0.5e-9, x[0] - 10);
            CHECK((body.particles.vector(fields::external_acceleration)[i] - expected).norm() <
                  1e-12);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a pressure gives its area's force, which turns and grows with the surface",
                       "", ((int Dim), Dim), 2, 3) {
    Scene<Dim> scene;
    constexpr int n = 6;
    Body<Dim>& body = scene.elastic("block", scene.lattice(n));
    body.shape = geometry::makeBox<Dim>(Vec<Dim>::Zero(), Vec<Dim>::Constant(n * spacing));
    const int rows = GENERATE(1, 2);
    scene.part(body, "top", [&](const Vec<Dim>& R) { return R[1] > (n - rows) * spacing; });
    Stepper<Dim> stepper(scene, body);
    const double width = n * spacing;
    const double area = std::pow(width, Dim - 1);
    const auto onTop = [&](const std::string& pressure) {
        return fmt::format(
            "type: force.surface_pressure, part: block.top, pressure: {}, thickness: {}, "
            "normal: [0, 7{}]",
            pressure, rows * spacing, Dim == 3 ? ", 0" : "");
    };

    SECTION("at rest") {
        const auto pressure = scene.method(onTop("5 + 2*x + t"));
        pressure->prepare();
        pressure.run({0.9, 0.2, 0});
        const double mean = 5 + width + 1;
        CHECK((massTimes(body, fields::external_acceleration) + mean * area * Vec<Dim>::Unit(1))
                  .norm() < round_off * mean);
        checkLoad(pressure, body);
    }
    SECTION("with the normal of the shape, away from the edges") {
        scene.part(body, "middle", [&](const Vec<Dim>& R) {
            bool inside = R[1] > (n - 1) * spacing;
            for (int c = 0; c < Dim; ++c)
                inside = inside && (c == 1 || std::abs(R[c] - width / 2) < 2 * spacing);
            return inside;
        });
        const auto pressure =
            scene.method("type: force.surface_pressure, part: block.middle, pressure: 5");
        pressure->prepare();
        pressure.run({});
        const double part = std::pow(4 * spacing, Dim - 1);
        CHECK(
            (massTimes(body, fields::external_acceleration) + 5 * part * Vec<Dim>::Unit(1)).norm() <
            round_off);
    }
    SECTION("deformed") {
        const auto pressure = scene.method(onTop("5"));
        const Mat<Dim> Q = rotation<Dim>(2.2, scene.random);
        Mat<Dim> stretch = Mat<Dim>::Identity();
        stretch(0, 0) = 1.5;  // along the face
        stretch(1, 1) = 0.8;  // across
        auto& F = body.particles.matrix(fields::deformation_gradient);
        for (std::size_t i = 0; i < body.size(); ++i) F[i] = Q * stretch;
        pressure->prepare();
        pressure.run({});
        const Vec<Dim> expected = -5 * 1.5 * area * Q.col(1);
        CHECK((massTimes(body, fields::external_acceleration) - expected).norm() <
              round_off * expected.norm());
    }
}

TEMPLATE_TEST_CASE_SIG("spring and dashpot: period and logarithmic decrement", "", ((int Dim), Dim),
                       2, 3) {
    Scene<Dim> scene;
    Body<Dim>& body = scene.elastic("block", scene.lattice(4));
    Stepper<Dim> stepper(scene, body);
    const double mass = massOf(body);
    const double omega = 40;
    const double ratio = GENERATE(0., 0.1);  // of the critical damping
    const double k = mass * omega * omega;
    const auto spring =
        scene.method(fmt::format("type: force.spring, part: block, stiffness: {}, damping: {}", k,
                                 2 * ratio * mass * omega));
    // The body also trembles in itself, of which its centre must not take notice.
    auto& velocity = body.particles.vector(fields::velocity);
    Vec<Dim> mean = Vec<Dim>::Zero();
    for (std::size_t i = 0; i < body.size(); ++i) {
        velocity[i] = scene.random.template vector<Dim>(0.5);
        mean += velocity[i] / static_cast<double>(body.size());
    }
    for (std::size_t i = 0; i < body.size(); ++i) velocity[i] += Vec<Dim>::Unit(0) - mean;
    stepper.start();

    spring.run({0, 1e-3, 0});
    checkLoad(spring, body);

    const Vec<Dim> rest = centreOf(body);
    const double omega_d = omega * std::sqrt(1 - ratio * ratio);
    const double dt = 2e-4;
    std::vector<double> crossings;
    std::vector<double> peaks;
    double before = 0;
    double earlier = 0;
    double off = 0;
    for (int step = 0; step < 2500; ++step) {
        stepper.step(dt, {&spring});
        const double u = centreOf(body)[0] - rest[0];
        const double t = stepper.clock.time;
        off = std::max(
            off, std::abs(u - std::exp(-ratio * omega * t) / omega_d * std::sin(omega_d * t)));
        if (before < 0 && u >= 0) crossings.push_back(t - dt * u / (u - before));
        if (before > earlier && before > u)
            peaks.push_back(before +
                            (u - earlier) * (u - earlier) / (8 * (2 * before - earlier - u)));
        earlier = before;
        before = u;
    }
    REQUIRE(crossings.size() == 3);
    REQUIRE(peaks.size() == 3);
    // Central differences: (omega dt)^2/24 = 2.7e-6 of the period, each.
    CHECK(off * omega < 1e-4);
    CHECK((crossings[2] - crossings[0]) / 2 ==
          Approx(2 * std::numbers::pi / omega_d).epsilon(1e-5));
    const double decrement = 2 * std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio);
    CHECK(std::abs(0.5 * std::log(peaks[0] / peaks[2]) - decrement) < 1e-4);
    CHECK((centreOf(body) - rest).template tail<Dim - 1>().norm() < 1e-12);
}

TEMPLATE_TEST_CASE_SIG("damping of the velocity: exact over any steps", "", ((int Dim), Dim), 2,
                       3) {
    Scene<Dim> scene;
    Body<Dim>& body = scene.elastic("block", scene.lattice(3));
    auto& velocity = body.particles.vector(fields::velocity);
    for (std::size_t i = 0; i < body.size(); ++i)
        velocity[i] = scene.random.template vector<Dim>(1);
    const std::vector<Vec<Dim>> before(velocity.data(), velocity.data() + body.size());
    const auto damping = scene.method("type: force.velocity_damping, body: block, rate: 40");
    for (const double dt : {0.01, 0.2, 0.003}) damping.run({0, dt, 0});
    for (std::size_t i = 0; i < body.size(); ++i)
        CHECK((velocity[i] - std::exp(-40 * 0.213) * before[i]).norm() < round_off);
}

TEMPLATE_TEST_CASE_SIG("damping of the velocity in a part of space", "", ((int Dim), Dim), 2, 3) {
    Scene<Dim> scene;
    Body<Dim>& body = scene.fluid("water", scene.box(Vec<Dim>::Zero(), Vec<Dim>::Ones()));
    Vec<Dim> corner = Vec<Dim>::Constant(2);
    corner[0] = 0.52;
    scene.world.shapes["beach"] = sphinx::geometry::makeBox<Dim>(Vec<Dim>::Constant(-1), corner);
    auto& velocity = body.particles.vector(fields::velocity);
    auto& position = body.particles.position();
    const Vec<Dim> v0 = Vec<Dim>::LinSpaced(Dim, 1, -2);
    for (std::size_t i = 0; i < body.size(); ++i) velocity[i] = v0;
    const auto isDamped = [](const Vec<Dim>& x) { return x[0] <= 0.52; };
    const auto damping =
        scene.method("type: force.velocity_damping, body: water, shape: beach, rate: '3*x + 2*t'");

    SECTION("exact of a rate that is linear in time") {
        double t = 0;
        for (const double dt : {0.1, 0.3, 0.05}) {
            damping.run({t, dt, 0});
            t += dt;
        }
        for (std::size_t i = 0; i < body.size(); ++i) {
            const double lost = isDamped(position[i]) ? 3 * position[i][0] * t + t * t : 0;
            CHECK((velocity[i] - std::exp(-lost) * v0).norm() < round_off);
        }
    }
    SECTION("of the particles that are in it at the time") {
        for (std::size_t i = 0; i < body.size(); ++i) position[i][0] = 1.2 - position[i][0];
        damping.run({0, 0.1, 0});
        for (std::size_t i = 0; i < body.size(); ++i)
            CHECK((velocity[i] == v0) == !isDamped(position[i]));
    }
    SECTION("stable at any rate, and without energy from nothing") {
        const auto strong =
            scene.method("type: force.velocity_damping, body: water, rate: 1e9*(1 + sin(40*x))");
        double before = 1e300;
        for (const double dt : {1e-12, 1e-9, 1e-3, 10.0}) {
            strong.run({0, dt, 0});
            double energy = 0;
            for (std::size_t i = 0; i < body.size(); ++i) energy += velocity[i].squaredNorm();
            CHECK(energy <= before);
            before = energy;
        }
        CHECK(before == 0);
    }
    SECTION("a rate below zero, or none, is an error with its place") {
        const auto driven =
            scene.method("type: force.velocity_damping, body: water, shape: beach, rate: 0.3 - x");
        CHECK_THROWS_WITH(
            driven.run({1, 0.5, 0}),
            Catch::StartsWith("the rate of damping of water is -0.05 1/s at (0.35, "));
        const auto early = scene.method("type: force.velocity_damping, body: water, rate: t - 2");
        CHECK_THROWS_WITH(
            early.run({1, 0.5, 0}),
            Catch::StartsWith("the rate of damping of water is -0.75 1/s at (0.05, "));
        // Outside of the shape it may be anything.
        const auto right =
            scene.method("type: force.velocity_damping, body: water, shape: beach, rate: 0.52 - x");
        right.run({0, 0.1, 0});
    }
}

TEST_CASE("the reaction of a body that is held is its weight") {
    const Vec<2> g(3, -10);
    Held block(Scene<2>().lattice(5, 0.1), {}, g);
    const Body<2>& body = block.body;

    SECTION("held as a whole: at once") {
        block.fix("block");
        block.step(1e-3);
        const MadeMethod<2>& fix = *block.support;
        Load<2> weight;
        for (std::size_t i = 0; i < body.size(); ++i)
            weight.add(body.particles.position()[i], body.particles.scalar(fields::mass)[i] * g);
        CHECK((fix.load().force + weight.force).norm() < round_off * weight.force.norm());
        CHECK((fix.load().moment + weight.moment).norm() < round_off * weight.moment.norm());
        test::MemoryArchive archive;
        fix->transfer(archive);
        fix->rest();
        CHECK(fix.load().force.isZero(0));
        archive.is_loading = true;
        fix->transfer(archive);
        CHECK((fix.load().moment + weight.moment).norm() < round_off * weight.moment.norm());
        for (std::size_t i = 0; i < body.size(); ++i)
            CHECK(body.particles.position()[i] ==
                  body.particles.vector(fields::initial_position)[i]);
    }
    SECTION("held along one axis: the other is free") {
        block.fix("block, directions: [y]");
        block.step(1e-3);
        const Vec<2> force = block.support->load().force;
        CHECK(force[0] == 0);
        CHECK(force[1] == Approx(10 * massOf(block.body)).epsilon(round_off));
        // Besides gravity the stresses of some twenty neighbors, which are zero but for their
        // rounding.
        const double rounding = 20 * 2.2e-16 * youngs_modulus / (density * spacing) * 1e-3;
        CHECK(std::abs(body.particles.vector(fields::velocity)[0][0] - 3e-3) < rounding);
    }
}

TEST_CASE("the reaction of a body that hangs is its weight when it has come to rest") {
    // Lowest axial mode: 35 1/s, decay rate eta omega^2/(2 E) of 1.2 1/s and more.
    Held bar(Scene<2>().lattice({4, 10}), {.damping = 2}, {0, -10});
    bar.fix("block.top");
    const auto time_step = bar.scene.timeStep("type: solid.acoustic_time_step, body: block");
    while (bar.stepper.clock.time < 15) bar.step(time_step->estimate());
    const Vec<2> force = bar.support->load().force;
    CHECK(force[1] == Approx(10 * massOf(bar.body)).epsilon(1e-6));
    CHECK(std::abs(force[0]) < 1e-6 * massOf(bar.body));
}
