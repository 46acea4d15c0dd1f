// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/reduce_force.h"

#include "../io/scene.h"
#include "dynamics/fluid/pressure_relaxation.h"
#include "dynamics/fluid/viscous_force.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

/// Water of 1 x 0.5 (deep 0.4 in 3D) on a floor, with two walls of four layers in x.
template <int Dim>
struct Tank : Scene<Dim> {
    static constexpr double density = 2;
    static constexpr double g = 5;
    static constexpr double height = 0.5;

    explicit Tank(double dp) {
        this->spacing = dp;
        const double w = 4 * dp;
        const auto box = [](double x0, double x1, double y0, double y1) {
            Box<Dim> b;
            b.lower.setZero();
            b.upper.setConstant(0.4);
            b.lower[0] = x0;
            b.upper[0] = x1;
            b.lower[Dim - 1] = y0;
            b.upper[Dim - 1] = y1;
            return b;
        };
        water = &this->fluid("water", box(0, 1, 0, height), density, 0.3);
        floor = &solid("floor", box(-w, 1 + w, -w, 0), Dim - 1, 1);
        left = &solid("left", box(-w, 0, 0, 1), 0, 1);
        right = &solid("right", box(1, 1 + w, 0, 1), 0, -1);
        if constexpr (Dim == 3) {
            // The third direction repeats itself.
            this->world.domain.bounds = {Vec<3>(-1, 0, -1), Vec<3>(2, 0.4, 2)};
            this->world.domain.periodic = {false, true, false};
        }
        water->sees = {water, floor, left, right};
        water->fluid().gravity[Dim - 1] = -g;
        ParticleSet<Dim>& p = water->particles;
        for (std::size_t i = 0; i < water->size(); ++i) {
            const double depth = height - p.position()[i][Dim - 1];
            p.scalar(fields::pressure)[i] = density * g * depth;
            p.scalar(fields::density)[i] = density + density * g * depth / 100;
            p.scalar(fields::volume)[i] = p.scalar(fields::mass)[i] / p.scalar(fields::density)[i];
            p.vector(fields::external_acceleration)[i] = water->gravity();
        }
        Context<Dim> context{this->world, this->relations};
        acoustic = std::make_unique<fluid::PressureRelaxation<Dim>>(
            context, *water, fluid::Riemann::low_dissipation);
        viscous = std::make_unique<fluid::ViscousForce<Dim>>(
            context, *water, fluid::WallSlip::no_slip, fluid::ViscousForm::laplacian);
    }
    Body<Dim>& solid(const std::string& name, const Box<Dim>& box, int axis, double side) {
        Body<Dim>& body = this->wall(name);
        this->fill(body, box);
        const double face = side > 0 ? box.upper[axis] : box.lower[axis];
        for (std::size_t i = 0; i < body.size(); ++i) {
            body.particles.vector(fields::normal)[i] = side * Vec<Dim>::Unit(axis);
            body.particles.scalar(fields::depth)[i] =
                std::abs(face - body.particles.position()[i][axis]);
        }
        return body;
    }
    /// Pressure and viscous force.
    std::pair<Vec<Dim>, Vec<Dim>> forceOn(const Body<Dim>& body) {
        OutputContext<Dim> context = this->context("");
        context.methods = {acoustic.get(), viscous.get()};
        const std::vector<double> row = rowOf(*makeForceSource(body, {}, context));
        const Vec<Dim> pressure(row.data());
        const Vec<Dim> friction(row.data() + Dim);
        const Vec<Dim> both(row.data() + 2 * Dim);
        CHECK((pressure + friction - both).norm() == 0);
        return {pressure, friction};
    }

    Body<Dim>* water;
    Body<Dim>* floor;
    Body<Dim>* left;
    Body<Dim>* right;
    std::unique_ptr<fluid::PressureRelaxation<Dim>> acoustic;
    std::unique_ptr<fluid::ViscousForce<Dim>> viscous;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("solids get exactly what the fluid loses", "", ((int Dim), Dim), 2, 3) {
    Tank<Dim> tank(Dim == 2 ? 0.04 : 0.08);
    Body<Dim>& water = *tank.water;
    ParticleSet<Dim>& p = water.particles;
    for (std::size_t i = 0; i < water.size(); ++i) {
        p.vector(fields::velocity)[i] = Vec<Dim>::LinSpaced(Dim, 1, -2) * std::sin(7.0 * i);
        p.position()[i] +=
            0.2 * tank.spacing * Vec<Dim>::LinSpaced(Dim, std::sin(2.0 * i), std::cos(5.0 * i));
    }
    ++water.version;
    tank.relations.update({&water, tank.floor, tank.left, tank.right});
    Vec<Dim> pressure = Vec<Dim>::Zero();
    Vec<Dim> friction = Vec<Dim>::Zero();
    double largest = 0;
    for (const Body<Dim>* body : {tank.floor, tank.left, tank.right}) {
        const auto [a, b] = tank.forceOn(*body);
        pressure += a;
        friction += b;
        largest = std::max({largest, a.norm(), b.norm()});
        CHECK(b.norm() > 0);
    }
    const auto total = [&](const Field<Vec<Dim>>& field) {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (std::size_t i = 0; i < water.size(); ++i) sum += p.scalar(fields::mass)[i] * field[i];
        return sum;
    };
    const Vec<Dim> weight = total(p.vector(fields::external_acceleration));
    const Vec<Dim> before = total(p.vector(fields::velocity));
    const double dt = 1e-3;
    tank.acoustic->firstHalf({0, dt, 0});
    const Vec<Dim> gained = (total(p.vector(fields::velocity)) - before) / dt;
    // The rest is round-off, magnified by 1/dt.
    CHECK((gained - weight + pressure).norm() < 1e-9 * largest);
}

TEST_CASE("friction on the walls is what viscosity takes from the fluid") {
    Tank<2> tank(0.04);
    Body<2>& water = *tank.water;
    ParticleSet<2>& p = water.particles;
    for (std::size_t i = 0; i < water.size(); ++i) {
        p.vector(fields::velocity)[i] = Vec<2>(3 * p.position()[i][1], 0.1);
        p.vector(fields::external_acceleration)[i].setZero();
    }
    tank.relations.update({&water, tank.floor, tank.left, tank.right});
    Vec<2> friction = Vec<2>::Zero();
    for (const Body<2>* body : {tank.floor, tank.left, tank.right})
        friction += tank.forceOn(*body).second;
    tank.viscous->run({});
    Vec<2> gained = Vec<2>::Zero();
    for (std::size_t i = 0; i < water.size(); ++i)
        gained += p.scalar(fields::mass)[i] * p.vector(fields::external_acceleration)[i];
    CHECK((gained + friction).norm() < 1e-12 * friction.norm());
    CHECK(tank.forceOn(*tank.floor).second[0] > 0);  // the floor is dragged along
}

TEST_CASE("moments of water at rest are those of its forces at the middle of the floor") {
    Tank<2> tank(0.04);
    tank.relations.update({tank.water, tank.floor, tank.left, tank.right});
    const double weight = tank.forceOn(*tank.floor).first[1];
    OutputContext<2> context = tank.context("");
    context.methods = {tank.acoustic.get(), tank.viscous.get()};
    const auto momentAbout = [&](const Vec<2>& about) {
        return rowOf(*makeForceSource<2>(*tank.floor, {}, context, about));
    };
    CHECK(std::abs(momentAbout(Vec<2>(0.5, 0))[0]) < 1e-12 * std::abs(weight));
    CHECK(momentAbout(Vec<2>(0, 0))[0] == Approx(0.5 * weight).epsilon(1e-12));
    // By pressure, by viscosity, both.
    CHECK(momentAbout(Vec<2>(0, 0))[1] == 0);
    CHECK(momentAbout(Vec<2>(0, 0))[2] == momentAbout(Vec<2>(0, 0))[0]);
}

TEST_CASE("moments by friction are those of the forces on the wall's particles") {
    Tank<2> tank(0.04);
    Body<2>& water = *tank.water;
    for (std::size_t i = 0; i < water.size(); ++i)
        water.particles.vector(fields::velocity)[i] = Vec<2>(1, -2) * std::sin(7.0 * i);
    Relation<2>& of_floor = tank.relations.flow(*tank.floor, water, {.distance = true});
    tank.relations.update({&water, tank.floor, tank.left, tank.right});
    Field<Vec<2>>& force = tank.floor->particles.vector(fields::viscous_force);
    const Vec<2> about(0.3, 0.2);
    const Relation<2>& of_water = tank.relations.flow(water, *tank.floor, {});
    for (const fluid::ViscousForm form :
         {fluid::ViscousForm::laplacian, fluid::ViscousForm::central}) {
        Context<2> context{tank.world, tank.relations};
        fluid::ViscousForce<2> viscous(context, water, fluid::WallSlip::no_slip, form);
        for (std::size_t j = 0; j < tank.floor->size(); ++j) force[j].setZero();
        viscous.addForces(*tank.floor, of_floor.list, force);
        Load<2> sum;
        for (std::size_t j = 0; j < tank.floor->size(); ++j)
            sum.add(tank.floor->particles.position()[j] - about, force[j]);
        const Load<2> load = viscous.loadOn(*tank.floor, of_water.list, about);
        // Lists hold gradients and distances as 32-bit whole numbers.
        CHECK((load.force - sum.force).norm() < 1e-12 * sum.force.norm());
        CHECK(load.moment[0] == Approx(sum.moment[0]).epsilon(1e-8));
    }
}

TEST_CASE("within an advection step the force is the one that the fluid feels") {
    Tank<2> tank(0.04);
    Body<2>& water = *tank.water;
    ParticleSet<2>& p = water.particles;
    tank.relations.update({&water, tank.floor, tank.left, tank.right});
    for (std::size_t i = 0; i < water.size(); ++i) {
        p.position()[i] += 0.1 * tank.spacing * Vec<2>(std::sin(2.0 * i), std::cos(5.0 * i));
        p.vector(fields::velocity)[i] = Vec<2>(1, -2) * std::sin(7.0 * i);
    }
    ++water.version;
    Vec<2> pressure = Vec<2>::Zero();
    for (const Body<2>* body : {tank.floor, tank.left, tank.right})
        pressure += tank.forceOn(*body).first;
    const auto momentum = [&] {
        Vec<2> sum = Vec<2>::Zero();
        for (std::size_t i = 0; i < water.size(); ++i)
            sum += p.scalar(fields::mass)[i] * p.vector(fields::velocity)[i];
        return sum;
    };
    Vec<2> weight = Vec<2>::Zero();
    for (std::size_t i = 0; i < water.size(); ++i)
        weight += p.scalar(fields::mass)[i] * water.gravity();
    const Vec<2> before = momentum();
    const double dt = 1e-3;
    tank.acoustic->firstHalf({0, dt, 0});
    const Vec<2> gained = (momentum() - before) / dt;
    CHECK((gained - weight + pressure).norm() < 1e-9 * pressure.norm());
}

TEST_CASE("the force does not depend on the order of the particles") {
    Tank<2> tank(0.04);
    Body<2>& water = *tank.water;
    tank.relations.update({&water, tank.floor, tank.left, tank.right});
    const Vec<2> before = tank.forceOn(*tank.floor).first;
    AlignedVector<Index> reversed(water.size());
    for (std::size_t i = 0; i < water.size(); ++i)
        reversed[i] = static_cast<Index>(water.size() - 1 - i);
    water.particles.permute(reversed);
    ++water.version;
    CHECK((tank.forceOn(*tank.floor).first - before).norm() < 1e-12 * before.norm());
}

TEST_CASE("lists of the loop are left alone by the force") {
    Tank<2> tank(0.04);
    tank.relations.update({tank.water});
    const Relation<2>& list = tank.relations.flow(*tank.water, *tank.floor, {});
    const std::uint64_t built = list.from_version;
    for (std::size_t i = 0; i < tank.water->size(); ++i)
        tank.water->particles.position()[i][1] += 0.01;
    ++tank.water->version;
    tank.forceOn(*tank.floor);
    CHECK(list.from_version == built);
}
