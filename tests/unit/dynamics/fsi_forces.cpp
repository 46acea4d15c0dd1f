// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../memory_archive.h"
#include "../scene/scene.h"
#include "../scene/values.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/radiation.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::dynamics::fluid;
using namespace sphinx::test;

namespace {

/// A block of fluid above an elastic block of half its spacing, all a little disordered and moving.
template <int Dim>
struct Meeting : Scene<Dim> {
    Meeting() {
        Vec<Dim> upper = Vec<Dim>::Constant(0.5);
        fluid =
            &move(Scene<Dim>::fluid("water", filled(Vec<Dim>::Zero(), upper), {.viscosity = 0.3}));
        Vec<Dim> lower = Vec<Dim>::Zero();
        lower[1] = -0.5;
        upper[1] = 0;
        this->spacing = 0.05;
        solid = &move(this->elastic("gate", filled(lower, upper), {.density = 3}));
        this->setFace(*solid, Face{});
        fluid->sees = {fluid, solid};
        solid->sees = {fluid};
    }
    std::vector<Vec<Dim>> filled(const Vec<Dim>& lower, const Vec<Dim>& upper) {
        return this->disordered(this->box(lower, upper), 0.1);
    }
    Body<Dim>& move(Body<Dim>& body) {
        for (const particles::FieldInfo* field : {&fields::velocity, &fields::average_velocity})
            give(body, *field,
                 [&](const Vec<Dim>&) { return this->random.template vector<Dim>(1); });
        for (std::size_t i = 0; i < body.size(); ++i)
            body.particles.scalar(fields::density)[i] *= this->random(0.99, 1.01);
        return body;
    }
    void updateLists() { this->relations.update({fluid, solid}); }
    Vec<Dim> momentum() const { return massTimes(*fluid, fields::velocity); }

    MadeMethod<Dim> pressure(const std::string& riemann) {
        return this->method("type: fluid.pressure_relaxation, body: water, riemann: " + riemann);
    }
    MadeMethod<Dim> viscosity(const std::string& form) { return viscosity(this->context, form); }
    static MadeMethod<Dim> viscosity(Context<Dim>& context, const std::string& form) {
        return {context, "type: fluid.viscous_force, body: water, form: " + form};
    }
    /// What hands either on to the solid.
    MadeMethod<Dim> handOn(const std::string& type) { return handOn(this->context, type); }
    static MadeMethod<Dim> handOn(Context<Dim>& context, const std::string& type) {
        return {context, "type: " + type + ", body: gate, from: water"};
    }

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
    for (const char* riemann : {"none", "dissipative", "low_dissipation"}) {
        Meeting<Dim> meeting;
        const auto pressure = meeting.pressure(riemann);
        auto& force = meeting.solid->particles.vector(fields::pressure_force);
        const auto load = meeting.handOn("fsi.pressure_force");
        meeting.updateLists();
        const Vec<Dim> before = meeting.momentum();
        const double dt = 1e-3;
        pressure.run({0, dt, 0}, "first_half");
        load.run({});
        const Vec<Dim> taken = (before - meeting.momentum()) / dt;
        CHECK(taken.norm() > 0.01);
        CHECK((taken - sumOf<Dim>(force)).norm() < 1e-12 * taken.norm());
    }
}

TEST_CASE(
    "of two pressure relaxations that share the time, the elastic body feels the one that acts") {
    Meeting<2> meeting;
    const auto first = meeting.pressure("dissipative");
    const auto* load_of_first = meeting.context.loads.back();
    const auto second = meeting.pressure("none");
    auto& force = meeting.solid->particles.vector(fields::pressure_force);
    const auto load = meeting.handOn("fsi.pressure_force");
    meeting.updateLists();
    const double dt = 1e-3;
    CHECK(presentLoad(meeting.context.loads, *meeting.fluid, LoadKind::pressure) == load_of_first);
    CHECK(presentLoad(meeting.context.loads, *meeting.fluid, LoadKind::viscous) == nullptr);
    double time = 0;
    for (const MadeMethod<2>* acting : {&first, &first, &second, &second}) {
        const Vec<2> before = meeting.momentum();
        acting->run({time, dt, 0}, "first_half");
        force.setZero();  // as the loop does
        load.run({time, dt, 0});
        const Vec<2> taken = (before - meeting.momentum()) / dt;
        CHECK((taken - sumOf<2>(force)).norm() < 1e-12 * taken.norm());
        acting->run({time, dt, 0}, "second_half");
        meeting.updateLists();
        time += dt;
    }
}

TEST_CASE("a load whose window is over pushes nothing, also after a restart") {
    Meeting<2> meeting;
    const auto present = [&](const Context<2>& context) {
        return presentLoad(context.loads, *meeting.fluid, LoadKind::viscous);
    };
    const auto isPresent = [&](const Context<2>& context, const MadeMethod<2>& method) {
        return present(context) == &method.as<SolidLoad<2>>();
    };
    const auto first = meeting.viscosity("central");
    const auto second = meeting.viscosity("laplacian");
    meeting.updateLists();
    first.run({0, 0.1, 0});
    second.run({0.1, 0.1, 1});
    CHECK(isPresent(meeting.context, second));

    Context<2> resumed{meeting.world, meeting.relations};
    const auto same_first = meeting.viscosity(resumed, "central");
    const auto same_second = meeting.viscosity(resumed, "laplacian");
    const auto resume = [&] {
        for (const auto& [from, to] : {std::pair{&first, &same_first}, {&second, &same_second}}) {
            MemoryArchive memory;
            (*from)->transfer(memory);
            memory.is_loading = true;
            (*to)->transfer(memory);
        }
    };
    CHECK(isPresent(resumed, same_first));
    resume();
    CHECK(isPresent(resumed, same_second));

    second->rest();
    CHECK(isPresent(meeting.context, first));
    first->rest();
    CHECK(present(meeting.context) == nullptr);
    resume();
    CHECK(present(resumed) == nullptr);
    auto& force = meeting.solid->particles.vector(fields::viscous_force);
    const auto load = meeting.handOn(resumed, "fsi.viscous_force");
    meeting.updateLists();
    load.run({});
    CHECK(sumOf<2>(force).norm() == 0);
    same_first.run({0.2, 0.1, 2});
    load.run({});
    CHECK(sumOf<2>(force).norm() > 0.01);
}

TEMPLATE_TEST_CASE_SIG("an elastic body takes the momentum that viscosity takes from the fluid", "",
                       ((int Dim), Dim), 2, 3) {
    for (const char* form : {"laplacian", "central"}) {
        Meeting<Dim> meeting;
        const auto viscous = meeting.viscosity(form);
        auto& force = meeting.solid->particles.vector(fields::viscous_force);
        const auto load = meeting.handOn("fsi.viscous_force");
        meeting.updateLists();
        viscous.run({});
        load.run({});
        const Vec<Dim> given = massTimes(*meeting.fluid, fields::external_acceleration);
        CHECK(given.norm() > 0.01);
        CHECK((given + sumOf<Dim>(force)).norm() < 1e-12 * given.norm());
    }
}

TEST_CASE("a fluid sees the mean velocity of an elastic body in its step") {
    Meeting<2> meeting;
    ParticleSet<2>& p = meeting.solid->particles;
    p.vector(fields::slip)[0] = Vec<2>(1, 2);
    const auto average = meeting.method("type: fsi.average_kinematics, body: gate");
    const Clock clock{0, 0.1, 0};
    const Vec<2> v(3, -2);
    average.run(clock, "begin");
    CHECK(p.vector(fields::slip)[0].norm() == 0);
    p.position()[0] += 0.1 * v;
    average.run(clock, "end");
    CHECK((p.vector(fields::average_velocity)[0] - v).norm() < 1e-12);
    CHECK(p.vector(fields::average_velocity)[1].norm() == 0);
}

TEMPLATE_TEST_CASE_SIG(
    "the work of the pressure on an elastic body is what the fluid's compression loses", "",
    ((int Dim), Dim), 2, 3) {
    Meeting<Dim> meeting;
    const auto pressure = meeting.pressure("none");
    const auto load = meeting.handOn("fsi.pressure_force");
    meeting.updateLists();
    ParticleSet<Dim>& water = meeting.fluid->particles;
    ParticleSet<Dim>& gate = meeting.solid->particles;
    const Field<Vec<Dim>> before = water.vector(fields::velocity);
    const double dt = 1e-9;
    pressure.run({0, dt, 0}, "first_half");
    load.run({});
    pressure.run({0, dt, 0}, "second_half");
    double kinetic = 0, internal = 0, work = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        const Vec<Dim> a = (water.vector(fields::velocity)[i] - before[i]) / dt;
        kinetic += water.scalar(fields::mass)[i] * a.dot(before[i]);
        internal += water.scalar(fields::pressure)[i] * water.scalar(fields::volume)[i] *
                    water.scalar(fields::density_rate)[i] / water.scalar(fields::density)[i];
    }
    for (std::size_t j = 0; j < gate.size(); ++j)
        work +=
            gate.vector(fields::pressure_force)[j].dot(gate.vector(fields::average_velocity)[j]);
    CHECK(std::abs(work) > 1e-3 * std::abs(internal));
    CHECK(std::abs(kinetic + internal + work) < 1e-5 * std::abs(work));
}

TEMPLATE_TEST_CASE_SIG("what answers an elastic body in its steps is taken from the fluid", "",
                       ((int Dim), Dim), 2, 3) {
    Meeting<Dim> meeting;
    meeting.solid->particles.vector(fields::average_velocity).setZero();
    const auto pressure = meeting.pressure("low_dissipation");
    const auto load = meeting.handOn("fsi.pressure_force");
    const auto average = meeting.method("type: fsi.average_kinematics, body: gate");
    const auto correction = meeting.method("type: solid.linear_correction, body: gate");
    const auto stress = meeting.method("type: solid.stress_relaxation, body: gate");
    for (const auto* method : {&correction, &stress}) (*method)->announce();
    for (const auto* method : {&correction, &stress}) (*method)->prepare();
    meeting.updateLists();
    correction.run({.is_start = true});
    const auto momentum = [&] {
        return Vec<Dim>(meeting.momentum() + massTimes(*meeting.solid, fields::velocity));
    };
    const Vec<Dim> before = momentum();
    const Vec<Dim> before_solid = massTimes(*meeting.solid, fields::velocity);
    const double dt = 1e-3;
    pressure.run({0, dt, 0}, "first_half");
    load.run({0, dt, 0});
    const Vec<Dim> held = dt * sumOf<Dim>(meeting.solid->particles.vector(fields::pressure_force));
    average.run({0, dt, 0}, "begin");
    for (int substep = 0; substep < 5; ++substep) {
        const Clock clock{substep * dt / 5, dt / 5, 0};
        stress.run(clock, "first_half");
        stress.run(clock, "second_half");
    }
    average.run({0, dt, 0}, "end");
    const Vec<Dim> got = massTimes(*meeting.solid, fields::velocity) - before_solid;
    CHECK((got - held).norm() > 1e-3 * held.norm());  // there is an answer
    pressure.run({0, dt, 0}, "second_half");
    CHECK((momentum() - before).norm() < 1e-13 * meeting.momentum().norm());
}

TEMPLATE_TEST_CASE_SIG(
    "a particle takes the velocity that fluids have seen, the sooner the lighter", "",
    ((int Dim), Dim), 2, 3) {
    Meeting<Dim> meeting;
    const auto pressure = meeting.pressure("none");
    const auto load = meeting.handOn("fsi.pressure_force");
    meeting.updateLists();
    pressure.run({0, 1e-3, 0}, "first_half");
    load.run({});
    ParticleSet<Dim>& gate = meeting.solid->particles;
    const Field<Mat<Dim>>& Z = gate.matrix(fields::radiation_impedance);
    const Field<Vec<Dim>>& seen = gate.vector(fields::average_velocity);
    Field<Vec<Dim>>& v = gate.vector(fields::velocity);
    const double m = gate.scalar(fields::mass)[0];
    const Field<Vec<Dim>> before = v;
    const double dt = 0.01;
    Radiation<Dim> radiation(gate);
    radiation.begin(dt);
    parallelForGroups(gate.size(), [&](const Group& group) {
        const VecOf<Dim, Wide> velocity = dynamics::load(v, group);
        store<Dim, 1>(velocity + dt * radiation.answer(group, velocity), v, group);
    });
    int answered = 0;
    for (std::size_t j = 0; j < gate.size(); ++j) {
        CHECK((Z[j] - Z[j].transpose()).norm() == 0);
        CHECK((m * (v[j] - before[j]) + dt * Z[j] * (v[j] - seen[j])).norm() < 1e-12 * m);
        answered += (v[j] - before[j]).norm() > 0 ? 1 : 0;
    }
    CHECK(answered > 10);
    CHECK(answered < static_cast<int>(gate.size()));

    SECTION("a support holds what is answered too") {
        std::array<bool, Dim> held{};
        held[0] = true;
        for (std::size_t j = 0; j < gate.size(); ++j) {
            const Vec<Dim> free = v[j];
            const Vec<Dim> force = radiation.impose(j, held, Vec<Dim>::Constant(0.25));
            CHECK(v[j][0] == 0.25);
            CHECK(force.tail(Dim - 1).norm() < 1e-12 * force.norm());
            const Vec<Dim> change = v[j] - free;
            CHECK((m * change + dt * Z[j] * change - dt * force).norm() < 1e-12 * m);
        }
    }
}
