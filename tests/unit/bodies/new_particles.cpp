// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/new_particles.h"

#include "../scene/bodies.h"
#include "../scene/expression.h"
#include "materials/fluid_laws.h"
#include "materials/holzapfel_muscle.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace sphinx;
using namespace sphinx::bodies;
using namespace sphinx::test;

namespace {

template <int Dim>
NewParticle<Dim> particle(const Vec<Dim>& position, double volume,
                          const Vec<Dim>& velocity = Vec<Dim>::Zero(), double pressure = 0) {
    NewParticle<Dim> made;
    made.position = position;
    made.volume = volume;
    made.velocity = velocity;
    made.pressure = pressure;
    return made;
}

template <int Dim>
std::vector<std::string_view> namesOf(const particles::ParticleSet<Dim>& particles) {
    std::vector<std::string_view> names;
    for (const auto& field : particles.all()) names.push_back(field->info().name);
    std::sort(names.begin(), names.end());
    return names;
}

using Names = std::vector<std::string_view>;

}  // namespace

TEMPLATE_TEST_CASE_SIG("a particle of a fluid made in the midst of a run", "", ((int Dim), Dim), 2,
                       3) {
    const auto equation =
        GENERATE(materials::EquationOfState::linear, materials::EquationOfState::tait);
    materials::WeaklyCompressibleFluidParameters of_water;
    of_water.density = density;
    of_water.sound_speed = sound_speed;
    of_water.equation_of_state = equation;
    Bodies<Dim> bodies;
    Body<Dim>& water = bodies.add("water", FluidRole<Dim>{materials::makeFluid(of_water)});
    addParticles(water, {particle<Dim>(Vec<Dim>::Constant(1), 0.25)});
    // Fields of methods, and what has become of the particle since.
    particles::ParticleSet<Dim>& p = water.particles;
    auto& average = p.scalar(fields::average_pressure);
    auto& reference = p.scalar(fields::reference_density);
    auto& external = p.vector(fields::external_acceleration);
    auto& rate = p.scalar(fields::density_rate);
    average[0] = reference[0] = rate[0] = 77;
    external[0].setConstant(77);
    const std::uint64_t version = water.version;

    const double pressure = 3;
    addParticles(water,
                 {particle<Dim>(Vec<Dim>::Constant(2), 0.5, Vec<Dim>::Constant(-1), pressure),
                  particle<Dim>(Vec<Dim>::Constant(3), 0.125)});
    REQUIRE(water.size() == 3);
    CHECK(p.id()[2] == 2);
    CHECK(water.version > version);
    CHECK(p.position()[1] == Vec<Dim>::Constant(2));
    CHECK(p.vector(fields::velocity)[1] == Vec<Dim>::Constant(-1));
    CHECK(p.scalar(fields::volume)[1] == 0.5);
    CHECK(p.scalar(fields::pressure)[1] == pressure);
    materials::withLaw(*water.fluid().material, [&](const auto& law) {
        CHECK(law.pressure(p.scalar(fields::density)[1]) == Approx(pressure));
    });
    CHECK(p.scalar(fields::mass)[1] == p.scalar(fields::density)[1] * 0.5);
    CHECK(average[1] == pressure);
    CHECK(reference[1] == p.scalar(fields::density)[1]);
    CHECK(external[1].isZero(0));
    CHECK(rate[1] == 0);
    CHECK(p.scalar(fields::density)[2] == density);
    CHECK(p.scalar(fields::mass)[2] == density * 0.125);
    CHECK(p.vector(fields::velocity)[2].isZero(0));
    CHECK(average[0] == 77);
}

TEST_CASE("a body has the fields of its kind, whether it has particles or not") {
    Bodies<2> bodies;
    SECTION("fluid") {
        const Body<2>& body = bodies.fluid("water", {});
        CHECK(namesOf(body.particles) ==
              Names{"density", "id", "mass", "position", "pressure", "velocity", "volume"});
    }
    SECTION("wall") {
        const Body<2>& body = bodies.wall("wall", {});
        CHECK(namesOf(body.particles) ==
              Names{"acceleration", "density", "id", "mass", "position", "velocity", "volume"});
    }
    SECTION("elastic") {
        const Body<2>& body = bodies.elastic("gate", {});
        CHECK(namesOf(body.particles) == Names{"acceleration", "density", "id", "initial_position",
                                               "mass", "position", "velocity", "volume"});
    }
    SECTION("observer") {
        const Body<2>& body = bodies.observer({Vec<2>(1, 2)}, {});
        CHECK(namesOf(body.particles) == Names{"id", "position"});
        CHECK(body.particles.position()[0] == Vec<2>(1, 2));
    }
}

TEST_CASE("a particle of muscle has the directions of its place") {
    materials::HolzapfelMuscleParameters p;
    p.density = density;
    p.a = p.b = p.lame_lambda = 1;
    p.fibre = expressions({"y", "x"}, unit::none);
    Bodies<2> bodies;
    Body<2>& body =
        bodies.add("muscle", ElasticRole<2>{std::make_shared<materials::HolzapfelMuscle>(p)});
    addParticles(body, {particle<2>(Vec<2>(0, 2), 1), particle<2>(Vec<2>(4, 3), 1)});
    CHECK(body.particles.vector(fields::fibre)[0] == Vec<2>(1, 0));
    CHECK(body.particles.vector(fields::fibre)[1].isApprox(Vec<2>(0.6, 0.8)));
    CHECK(std::abs(body.particles.vector(fields::sheet)[1].dot(Vec<2>(0.6, 0.8))) < 1e-15);
}

TEST_CASE("parts of a body follow its particles") {
    Bodies<2> bodies;
    bodies.spacing = 1;
    Body<2>& body = bodies.elastic("gate", {});
    body.parts.push_back({"left", {}, geometry::makeBox<2>(Vec<2>(-10, -10), Vec<2>(1.2, 10))});
    body.elastic().clamps = {&body.parts[0]};
    std::vector<NewParticle<2>> row;
    for (const double x : {3.0, 0.0, 1.0, 2.0}) row.push_back(particle<2>(Vec<2>(x, 0), 1));
    addParticles(body, row);
    const auto& places = body.parts[0].particles;
    using Places = AlignedVector<Index>;
    const auto sharesAreRight = [&] {
        for (std::size_t i = 0; i < body.size(); ++i) {
            const double x = body.particles.vector(fields::initial_position)[i][0];
            if (body.elastic().share(i) != Approx(std::clamp(0.5 + x - 1.2, 0.0, 1.0)))
                return false;
        }
        return body.elastic().shares.size() == body.size();
    };
    CHECK(places == Places{1, 2});
    CHECK(sharesAreRight());
    // They belong to it by where they began, wherever they have gone since.
    for (std::size_t i = 0; i < 4; ++i) body.particles.position()[i] += Vec<2>(100, 0);

    SECTION("which change places") {
        body.particles.permute({2, 0, 3, 1});
        CHECK(places == Places{0, 3});
    }
    SECTION("of which some go") {
        body.particles.remove({0, 1});
        CHECK(places == Places{0});
    }
    SECTION("of which some come") {
        addParticles(body, {particle<2>(Vec<2>(5, 0), 1), particle<2>(Vec<2>(1.1, 3), 1)});
        CHECK(places == Places{1, 2, 5});
    }
    SECTION("which are read from a restart") {
        body.particles.restore(2, 2);
        body.particles.vector(fields::initial_position)[0] = Vec<2>(7, 0);
        body.particles.vector(fields::initial_position)[1] = Vec<2>(1, 0);
        body.findParts();
        CHECK(places == Places{1});
    }
    CHECK(sharesAreRight());
}
