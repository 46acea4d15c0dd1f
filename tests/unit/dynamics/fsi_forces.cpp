// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../memory_archive.h"
#include "dynamics/fluid/pressure_relaxation.h"
#include "dynamics/fluid/viscous_force.h"
#include "dynamics/fsi/average_kinematics.h"
#include "dynamics/fsi/fluid_force.h"
#include "materials/saint_venant_kirchhoff.h"
#include "materials/weakly_compressible_fluid.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <random>
#include <string>

using namespace sphinx;
using namespace sphinx::fluid;

namespace {

/// A block of fluid above an elastic block of half its spacing, all a little disordered and moving.
template <int Dim>
struct Meeting {
    Meeting() {
        fluid = add(FluidRole<Dim>{std::make_shared<LinearFluid>(2, 10, 0.3)}, 0.1, 5, 0);
        IsotropicParameters rubber;
        rubber.density = 3;
        rubber.lame_lambda = 100;
        rubber.lame_mu = 50;
        solid = add(ElasticRole<Dim>{std::make_shared<SaintVenantKirchhoff>(rubber)}, 0.05, 10, 1);
        fluid->sees = {fluid, solid};
        solid->sees = {fluid};
    }
    Body<Dim>* add(decltype(Body<Dim>::role) role, double spacing, int n, int layers_below) {
        Body<Dim>& body = *world.bodies.emplace_back(std::make_unique<Body<Dim>>());
        body.role = std::move(role);
        body.spacing = spacing;
        body.kernel = Kernel<Dim>(KernelType::wendland_c2, 1.3 * spacing, spacing);
        std::vector<Vec<Dim>> points;
        const int layers = Dim == 3 ? n : 1;
        for (int k = 0; k < layers; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    Vec<Dim> x = Vec<Dim>::Constant(spacing * (k + 0.5));
                    x[0] = spacing * (i + 0.5);
                    x[1] = spacing * (layers_below ? -(j + 0.5) : j + 0.5);
                    for (int c = 0; c < Dim; ++c) x[c] += 0.1 * spacing * number(random);
                    points.push_back(x);
                }
        ParticleSet<Dim>& p = body.particles;
        p.append(points.size());
        const double V = std::pow(spacing, Dim);
        const double rho = body.material()->density();
        for (std::size_t i = 0; i < points.size(); ++i) {
            p.position()[i] = points[i];
            p.scalar(fields::volume)[i] = V;
            p.scalar(fields::mass)[i] = rho * V;
            p.scalar(fields::density)[i] = rho * (1 + 0.01 * number(random));
            p.scalar(fields::depth)[i] = std::max(0.0, -points[i][1]);
            p.vector(fields::normal)[i] = Vec<Dim>::Unit(1);
            for (int c = 0; c < Dim; ++c) {
                p.vector(fields::velocity)[i][c] = number(random);
                p.vector(fields::average_velocity)[i][c] = number(random);
            }
        }
        return &body;
    }
    Vec<Dim> momentum() const {
        Vec<Dim> sum = Vec<Dim>::Zero();
        for (std::size_t i = 0; i < fluid->size(); ++i)
            sum += fluid->particles.scalar(fields::mass)[i] *
                   fluid->particles.vector(fields::velocity)[i];
        return sum;
    }

    std::mt19937 random{1};
    std::uniform_real_distribution<double> number{-1, 1};
    World<Dim> world;
    Relations<Dim> relations{world};
    Context<Dim> context{world, relations};
    Body<Dim>* fluid;
    Body<Dim>* solid;
};

template <int Dim>
Vec<Dim> sumOf(const Field<Vec<Dim>>& values) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[i];
    return sum;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("an elastic body takes the momentum that pressure takes from the fluid", "",
                       ((int Dim), Dim), 2, 3) {
    for (const Riemann riemann : {Riemann::none, Riemann::dissipative, Riemann::low_dissipation}) {
        Meeting<Dim> meeting;
        PressureRelaxation<Dim> pressure(meeting.context, *meeting.fluid, riemann);
        auto& force = meeting.solid->particles.vector(fields::pressure_force);
        fsi::FluidForce<Dim> load(meeting.context, *meeting.solid, *meeting.fluid,
                                  LoadKind::pressure, force);
        meeting.relations.update({meeting.fluid, meeting.solid});
        const Vec<Dim> before = meeting.momentum();
        const double dt = 1e-3;
        pressure.firstHalf({0, dt, 0});
        load.run({});
        const Vec<Dim> taken = (before - meeting.momentum()) / dt;
        CHECK(taken.norm() > 0.01);
        CHECK((taken - sumOf<Dim>(force)).norm() < 1e-12 * taken.norm());
    }
}

TEST_CASE(
    "of two pressure relaxations that share the time, the elastic body feels the one that acts") {
    Meeting<2> meeting;
    PressureRelaxation<2> first(meeting.context, *meeting.fluid, Riemann::dissipative);
    PressureRelaxation<2> second(meeting.context, *meeting.fluid, Riemann::none);
    auto& force = meeting.solid->particles.vector(fields::pressure_force);
    fsi::FluidForce<2> load(meeting.context, *meeting.solid, *meeting.fluid, LoadKind::pressure,
                            force);
    meeting.relations.update({meeting.fluid, meeting.solid});
    const double dt = 1e-3;
    CHECK(presentLoad(meeting.context.loads, *meeting.fluid, LoadKind::pressure) == &first);
    CHECK(presentLoad(meeting.context.loads, *meeting.fluid, LoadKind::viscous) == nullptr);
    double time = 0;
    for (PressureRelaxation<2>* acting : {&first, &first, &second, &second}) {
        const Vec<2> before = meeting.momentum();
        acting->firstHalf({time, dt, 0});
        force.setZero();  // as the loop does
        load.run({time, dt, 0});
        const Vec<2> taken = (before - meeting.momentum()) / dt;
        CHECK((taken - sumOf<2>(force)).norm() < 1e-12 * taken.norm());
        acting->secondHalf({time, dt, 0});
        meeting.relations.update({meeting.fluid, meeting.solid});
        time += dt;
    }
}

TEST_CASE("a load whose window is over pushes nothing, also after a restart") {
    Meeting<2> meeting;
    const auto present = [&](const Context<2>& context) {
        return presentLoad(context.loads, *meeting.fluid, LoadKind::viscous);
    };
    using Viscous = ViscousForce<2>;
    Viscous first(meeting.context, *meeting.fluid, WallSlip::no_slip, ViscousForm::central);
    Viscous second(meeting.context, *meeting.fluid, WallSlip::no_slip, ViscousForm::laplacian);
    meeting.relations.update({meeting.fluid, meeting.solid});
    first.run({0, 0.1, 0});
    second.run({0.1, 0.1, 1});
    CHECK(present(meeting.context) == &second);

    Context<2> resumed{meeting.world, meeting.relations};
    Viscous same_first(resumed, *meeting.fluid, WallSlip::no_slip, ViscousForm::central);
    Viscous same_second(resumed, *meeting.fluid, WallSlip::no_slip, ViscousForm::laplacian);
    const auto resume = [&] {
        for (const auto& [from, to] : {std::pair{&first, &same_first}, {&second, &same_second}}) {
            test::MemoryArchive memory;
            from->transfer(memory);
            memory.is_loading = true;
            to->transfer(memory);
        }
    };
    CHECK(present(resumed) == &same_first);
    resume();
    CHECK(present(resumed) == &same_second);

    second.rest();
    CHECK(present(meeting.context) == &first);
    first.rest();
    CHECK(present(meeting.context) == nullptr);
    resume();
    CHECK(present(resumed) == nullptr);
    auto& force = meeting.solid->particles.vector(fields::viscous_force);
    fsi::FluidForce<2> load(resumed, *meeting.solid, *meeting.fluid, LoadKind::viscous, force);
    meeting.relations.update({meeting.fluid, meeting.solid});
    load.run({});
    CHECK(sumOf<2>(force).norm() == 0);
    same_first.run({0.2, 0.1, 2});
    load.run({});
    CHECK(sumOf<2>(force).norm() > 0.01);
}

TEMPLATE_TEST_CASE_SIG("an elastic body takes the momentum that viscosity takes from the fluid", "",
                       ((int Dim), Dim), 2, 3) {
    for (const ViscousForm form : {ViscousForm::laplacian, ViscousForm::central}) {
        Meeting<Dim> meeting;
        ViscousForce<Dim> viscous(meeting.context, *meeting.fluid, WallSlip::no_slip, form);
        auto& force = meeting.solid->particles.vector(fields::viscous_force);
        fsi::FluidForce<Dim> load(meeting.context, *meeting.solid, *meeting.fluid,
                                  LoadKind::viscous, force);
        meeting.relations.update({meeting.fluid, meeting.solid});
        viscous.run({});
        load.run({});
        Vec<Dim> given = Vec<Dim>::Zero();
        for (std::size_t i = 0; i < meeting.fluid->size(); ++i)
            given += meeting.fluid->particles.scalar(fields::mass)[i] *
                     meeting.fluid->particles.vector(fields::external_acceleration)[i];
        CHECK(given.norm() > 0.01);
        CHECK((given + sumOf<Dim>(force)).norm() < 1e-12 * given.norm());
    }
}

TEST_CASE("a fluid sees the velocity of an elastic body at the end of its step") {
    Meeting<2> meeting;
    ParticleSet<2>& p = meeting.solid->particles;
    p.vector(fields::average_velocity).setZero();
    fsi::AverageKinematics<2> average(*meeting.solid);
    Clock clock;
    clock.dt = 0.1;
    const Vec<2> a(3, -2);
    // Uniformly accelerated from rest, the first step excepted, in which the mean is all there is.
    for (int step = 0; step < 3; ++step) {
        average.begin(clock);
        const double begin = step * clock.dt;
        const double end = begin + clock.dt;
        p.position()[0] += 0.5 * a * (end * end - begin * begin);
        average.end(clock);
        if (step == 0) continue;
        CHECK((p.vector(fields::average_acceleration)[0] - a).norm() < 1e-12);
        CHECK((p.vector(fields::average_velocity)[0] - a * end).norm() < 1e-12);
    }
}
