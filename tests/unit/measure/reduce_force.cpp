// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_force.h"

#include "../scene/outputs.h"
#include "../scene/values.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>

using namespace sphinx;
using namespace sphinx::measure;
using namespace sphinx::test;

namespace {

/// Water of 1 x 0.5 (deep 0.4 in 3D) on a floor, with two walls of four layers in x.
template <int Dim>
struct Tank : Scene<Dim> {
    static constexpr double g = 5;
    static constexpr double height = 0.5;

    explicit Tank(double dp) {
        this->spacing = dp;
        const double w = 4 * dp;
        const auto filled = [&](double x0, double x1, double y0, double y1) {
            Vec<Dim> lower = Vec<Dim>::Zero();
            Vec<Dim> upper = Vec<Dim>::Constant(0.4);
            lower[0] = x0;
            upper[0] = x1;
            lower[Dim - 1] = y0;
            upper[Dim - 1] = y1;
            return this->box(lower, upper);
        };
        water = &this->fluid("water", filled(0, 1, 0, height), {.viscosity = 0.3});
        floor = &this->wall("floor", filled(-w, 1 + w, -w, 0), {.axis = Dim - 1});
        left = &this->wall("left", filled(-w, 0, 0, 1), {.axis = 0});
        right = &this->wall("right", filled(1, 1 + w, 0, 1), {.axis = 0, .at = 1, .side = -1});
        // The third direction repeats itself.
        if constexpr (Dim == 3) this->repeat(1, Vec<3>(-1, 0, -1), Vec<3>(2, 0.4, 2));
        water->sees = {water, floor, left, right};
        water->fluid().gravity[Dim - 1] = -g;
        const auto pressure = [](const Vec<Dim>& x) { return density * g * (height - x[Dim - 1]); };
        give(*water, fields::pressure, pressure);
        give(*water, fields::density, [&](const Vec<Dim>& x) {
            return density + pressure(x) / (sound_speed * sound_speed);
        });
        give(*water, fields::external_acceleration,
             [&](const Vec<Dim>&) -> Vec<Dim> { return water->gravity(); });
        particles::ParticleSet<Dim>& p = water->particles;
        for (std::size_t i = 0; i < water->size(); ++i)
            p.scalar(fields::volume)[i] = p.scalar(fields::mass)[i] / p.scalar(fields::density)[i];
        acoustic.emplace(this->method("type: fluid.pressure_relaxation, body: water"));
        acoustic_load = this->context.loads.back();
        viscous.emplace(viscosity("laplacian"));
        updateLists();
    }
    MadeMethod<Dim> viscosity(const std::string& form) {
        return this->method("type: fluid.viscous_force, body: water, form: " + form);
    }
    void updateLists() { this->relations.update({water, floor, left, right}); }
    io::OutputContext<Dim> outputs() {
        io::OutputContext<Dim> context = outputContext(*this);
        context.methods = {acoustic->get(), viscous->get()};
        context.loads = {acoustic_load, &viscous->template as<dynamics::fluid::SolidLoad<Dim>>()};
        return context;
    }
    ReducedBody<Dim> all(bodies::Body<Dim>& body) { return {{&body}, {}, {}, &this->relations}; }
    ReducedBody<Dim> of(const dynamics::Part<Dim>& part) {
        return {{&part.body(), part.named()}, {}, {}, &this->relations};
    }
    /// Pressure and viscous force.
    std::pair<Vec<Dim>, Vec<Dim>> forceOn(bodies::Body<Dim>& body) { return forceOn(all(body)); }
    std::pair<Vec<Dim>, Vec<Dim>> forceOn(const ReducedBody<Dim>& reduced) {
        const std::vector<double> row = rowOf(*makeForceSource(reduced, outputs()));
        const Vec<Dim> pressure(row.data());
        const Vec<Dim> friction(row.data() + Dim);
        const Vec<Dim> both(row.data() + 2 * Dim);
        CHECK((pressure + friction - both).norm() == 0);
        return {pressure, friction};
    }

    bodies::Body<Dim>* water;
    bodies::Body<Dim>* floor;
    bodies::Body<Dim>* left;
    bodies::Body<Dim>* right;
    std::optional<MadeMethod<Dim>> acoustic;
    const dynamics::fluid::SolidLoad<Dim>* acoustic_load;
    std::optional<MadeMethod<Dim>> viscous;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("solids get exactly what the fluid loses", "", ((int Dim), Dim), 2, 3) {
    Tank<Dim> tank(Dim == 2 ? 0.04 : 0.08);
    bodies::Body<Dim>& water = *tank.water;
    particles::ParticleSet<Dim>& p = water.particles;
    for (std::size_t i = 0; i < water.size(); ++i) {
        p.vector(fields::velocity)[i] = Vec<Dim>::LinSpaced(Dim, 1, -2) * std::sin(7.0 * i);
        p.position()[i] +=
            0.2 * tank.spacing * Vec<Dim>::LinSpaced(Dim, std::sin(2.0 * i), std::cos(5.0 * i));
    }
    ++water.version;
    tank.updateLists();
    Vec<Dim> pressure = Vec<Dim>::Zero();
    Vec<Dim> friction = Vec<Dim>::Zero();
    double largest = 0;
    for (bodies::Body<Dim>* body : {tank.floor, tank.left, tank.right}) {
        const auto [a, b] = tank.forceOn(*body);
        pressure += a;
        friction += b;
        largest = std::max({largest, a.norm(), b.norm()});
        CHECK(b.norm() > 0);
    }
    const Vec<Dim> weight = massTimes(water, fields::external_acceleration);
    const Vec<Dim> before = massTimes(water, fields::velocity);
    const double dt = 1e-3;
    tank.acoustic->run({0, dt, 0}, "first_half");
    const Vec<Dim> gained = (massTimes(water, fields::velocity) - before) / dt;
    // The rest is round-off, magnified by 1/dt.
    CHECK((gained - weight + pressure).norm() < 1e-9 * largest);
}

TEST_CASE("friction on the walls is what viscosity takes from the fluid") {
    Tank<2> tank(0.04);
    bodies::Body<2>& water = *tank.water;
    give(water, fields::velocity, [](const Vec<2>& x) { return Vec<2>(3 * x[1], 0.1); });
    water.particles.vector(fields::external_acceleration).setZero();
    Vec<2> friction = Vec<2>::Zero();
    for (bodies::Body<2>* body : {tank.floor, tank.left, tank.right})
        friction += tank.forceOn(*body).second;
    tank.viscous->run({});
    const Vec<2> gained = massTimes(water, fields::external_acceleration);
    CHECK((gained + friction).norm() < 1e-12 * friction.norm());
    CHECK(tank.forceOn(*tank.floor).second[0] > 0);  // the floor is dragged along
}

TEST_CASE("moments of water at rest are those of its forces at the middle of the floor") {
    Tank<2> tank(0.04);
    const double weight = tank.forceOn(*tank.floor).first[1];
    const auto momentAbout = [&](const Vec<2>& about) {
        return rowOf(*makeForceSource<2>(tank.all(*tank.floor), tank.outputs(), about));
    };
    CHECK(std::abs(momentAbout(Vec<2>(0.5, 0))[0]) < 1e-12 * std::abs(weight));
    CHECK(momentAbout(Vec<2>(0, 0))[0] == Approx(0.5 * weight).epsilon(1e-12));
    // By pressure, by viscosity, both.
    CHECK(momentAbout(Vec<2>(0, 0))[1] == 0);
    CHECK(momentAbout(Vec<2>(0, 0))[2] == momentAbout(Vec<2>(0, 0))[0]);
}

TEMPLATE_TEST_CASE_SIG("forces and moments on parts of a wall are those on the wall", "",
                       ((int Dim), Dim), 2, 3) {
    Tank<Dim> tank(Dim == 2 ? 0.04 : 0.08);
    bodies::Body<Dim>& water = *tank.water;
    for (std::size_t i = 0; i < water.size(); ++i)
        water.particles.vector(fields::velocity)[i] =
            Vec<Dim>::LinSpaced(Dim, 1, -2) * std::sin(7.0 * i);
    const auto isLow = [](const Vec<Dim>& r) { return r[Dim - 1] < 0.21; };
    tank.addPart(*tank.left, "low", isLow);
    tank.addPart(*tank.left, "high", [&](const auto& r) { return !isLow(r); });
    tank.addPart(*tank.left, "none", [](const auto&) { return false; });
    const auto low = tank.part("left.low");
    const auto rowsOf = [&](const ReducedBody<Dim>& reduced) {
        std::vector<double> all;
        for (const auto& about :
             {std::optional<Vec<Dim>>(), std::optional(Vec<Dim>(0.3 * Vec<Dim>::Ones()))})
            for (const double value : rowOf(*makeForceSource(reduced, tank.outputs(), about)))
                all.push_back(value);
        return all;
    };
    const auto whole = rowsOf(tank.all(*tank.left));
    const auto a = rowsOf(tank.of(low));
    const auto b = rowsOf(tank.of(tank.part("left.high")));
    const auto c = rowsOf(tank.of(tank.part("left.none")));
    double largest = 0;
    for (const double value : whole) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < whole.size(); ++k) {
        CHECK(std::abs(whole[k] - a[k] - b[k]) < 1e-12 * largest);
        CHECK(c[k] == 0);
    }
    CHECK(std::abs(a[0]) > 1.2 * std::abs(b[0]));
    // Sorted particles of the fluid are the same ones.
    water.particles.permute(reversed(water));
    ++water.version;
    const auto again = rowsOf(tank.of(low));
    for (std::size_t k = 0; k < whole.size(); ++k)
        CHECK(std::abs(again[k] - a[k]) < 1e-12 * largest);
}

TEST_CASE("the water's pressure on a part of a wall") {
    // Between the depths d1 and d2 rho g (d2^2 - d1^2)/2.
    Tank<2> tank(0.01);
    const auto part =
        tank.part(*tank.left, "band", [](const Vec<2>& r) { return r[1] > 0.1 && r[1] < 0.3; });
    const double expected = density * Tank<2>::g * (0.4 * 0.4 - 0.2 * 0.2) / 2;
    const double found = -tank.forceOn(tank.of(part)).first[0];
    CHECK(found == Approx(expected).epsilon(0.03));
    // The kernel sums at a wall are too small by the same factor everywhere.
    const double whole = density * Tank<2>::g * 0.5 * 0.5 / 2;
    CHECK(found / -tank.forceOn(*tank.left).first[0] == Approx(expected / whole).epsilon(0.01));
}

TEST_CASE("moments by friction are those of the forces on the wall's particles") {
    Tank<2> tank(0.04);
    bodies::Body<2>& water = *tank.water;
    for (std::size_t i = 0; i < water.size(); ++i)
        water.particles.vector(fields::velocity)[i] = Vec<2>(1, -2) * std::sin(7.0 * i);
    neighbors::Relation<2>& of_floor = tank.relations.flow(*tank.floor, water, {.distance = true});
    tank.updateLists();
    particles::Field<Vec<2>>& force = tank.floor->particles.vector(fields::viscous_force);
    const Vec<2> about(0.3, 0.2);
    const neighbors::Relation<2>& of_water = tank.relations.flow(water, *tank.floor, {});
    for (const char* form : {"laplacian", "central"}) {
        const MadeMethod<2> made = tank.viscosity(form);
        const auto& viscous = made.as<dynamics::fluid::SolidLoad<2>>();
        force.setZero();
        viscous.addForces(*tank.floor, of_floor.list, force);
        dynamics::Load<2> sum;
        for (std::size_t j = 0; j < tank.floor->size(); ++j)
            sum.add(tank.floor->particles.position()[j] - about, force[j]);
        const dynamics::Load<2> load = viscous.loadOn(*tank.floor, of_water.list, about);
        // Lists hold gradients and distances as 32-bit whole numbers.
        CHECK((load.force - sum.force).norm() < 1e-12 * sum.force.norm());
        CHECK(load.moment[0] == Approx(sum.moment[0]).epsilon(1e-8));
    }
}

TEST_CASE("within an advection step the force is the one that the fluid feels") {
    Tank<2> tank(0.04);
    bodies::Body<2>& water = *tank.water;
    particles::ParticleSet<2>& p = water.particles;
    for (std::size_t i = 0; i < water.size(); ++i) {
        p.position()[i] += 0.1 * tank.spacing * Vec<2>(std::sin(2.0 * i), std::cos(5.0 * i));
        p.vector(fields::velocity)[i] = Vec<2>(1, -2) * std::sin(7.0 * i);
    }
    ++water.version;
    Vec<2> pressure = Vec<2>::Zero();
    for (bodies::Body<2>* body : {tank.floor, tank.left, tank.right})
        pressure += tank.forceOn(*body).first;
    const Vec<2> weight = massOf(water) * water.gravity();
    const Vec<2> before = massTimes(water, fields::velocity);
    const double dt = 1e-3;
    tank.acoustic->run({0, dt, 0}, "first_half");
    const Vec<2> gained = (massTimes(water, fields::velocity) - before) / dt;
    CHECK((gained - weight + pressure).norm() < 1e-9 * pressure.norm());
}

TEST_CASE("the force does not depend on the order of the particles") {
    Tank<2> tank(0.04);
    bodies::Body<2>& water = *tank.water;
    const Vec<2> before = tank.forceOn(*tank.floor).first;
    water.particles.permute(reversed(water));
    ++water.version;
    CHECK((tank.forceOn(*tank.floor).first - before).norm() < 1e-12 * before.norm());
}

TEST_CASE("lists of the loop are left alone by the force") {
    Tank<2> tank(0.04);
    const neighbors::Relation<2>& list = tank.relations.flow(*tank.water, *tank.floor, {});
    const std::uint64_t built = list.from_version;
    for (std::size_t i = 0; i < tank.water->size(); ++i)
        tank.water->particles.position()[i][1] += 0.01;
    ++tank.water->version;
    tank.forceOn(*tank.floor);
    CHECK(list.from_version == built);
}
