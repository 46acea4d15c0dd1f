// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/particle_set.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace sphinx;
using namespace sphinx::particles;

namespace {

using Ids = std::vector<std::int64_t>;

/// Particles of which every given value tells the id.
template <int Dim>
void add(ParticleSet<Dim>& particles, std::size_t n) {
    particles.append(n, [&](std::size_t first) {
        for (std::size_t i = first; i < particles.size(); ++i) {
            const auto id = static_cast<double>(particles.id()[i]);
            particles.position()[i].setConstant(id + 0.5);
            particles.scalar(fields::density)[i] = 100 + id;
        }
    });
}

template <int Dim>
Ids idsOf(ParticleSet<Dim>& particles) {
    return {particles.id().data(), particles.id().data() + particles.size()};
}

/// Every value stands where the id does.
template <int Dim>
bool together(ParticleSet<Dim>& particles) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto id = static_cast<double>(particles.id()[i]);
        if (particles.position()[i] != Vec<Dim>::Constant(id + 0.5) ||
            particles.scalar(fields::density)[i] != 100 + id)
            return false;
    }
    return particles.position().size() == particles.size() &&
           particles.scalar(fields::density).size() == particles.size();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("particles come, go and change places with all their values", "",
                       ((int Dim), Dim), 2, 3) {
    ParticleSet<Dim> particles;
    particles.scalar(fields::density);
    add(particles, 5);
    CHECK(idsOf(particles) == Ids{0, 1, 2, 3, 4});
    CHECK(together(particles));

    SECTION("appended ones continue the ids") {
        particles.remove({4});
        add(particles, 2);
        CHECK(idsOf(particles) == Ids{0, 1, 2, 3, 5, 6});
        CHECK(particles.nextId() == 7);
        CHECK(together(particles));
    }
    SECTION("those that stay keep their order when some are removed") {
        particles.remove({0, 2, 4});
        CHECK(idsOf(particles) == Ids{1, 3});
        CHECK(together(particles));
        particles.remove({0, 1});
        CHECK(particles.size() == 0);
        CHECK(together(particles));
    }
    SECTION("permuted") {
        particles.permute({3, 0, 4, 1, 2});
        CHECK(idsOf(particles) == Ids{3, 0, 4, 1, 2});
        CHECK(together(particles));
    }
    SECTION("restored ones know nothing of those before") {
        particles.restore(3, 10);
        CHECK(particles.size() == 3);
        CHECK(particles.nextId() == 10);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(particles.scalar(fields::density)[i] == 0);
            CHECK(particles.position()[i].isZero(0));
        }
        particles.append(1);
        CHECK(particles.id()[3] == 10);
    }
    SECTION("every change of places is counted, and removing nothing is none") {
        const std::uint64_t before = particles.arrangement();
        particles.remove({});
        CHECK(particles.arrangement() == before);
        particles.append(1);
        particles.remove({0});
        particles.permute({0, 1, 2, 4, 3});
        particles.restore(5, 6);
        CHECK(particles.arrangement() == before + 4);
    }
}

TEMPLATE_TEST_CASE_SIG("new particles have the initial values of their fields", "",
                       ((int Dim), Dim), 2, 3) {
    ParticleSet<Dim> particles;
    particles.vector(fields::initial_position);  // before there is a particle
    particles.scalar(fields::reference_density);
    particles.matrix(fields::deformation_gradient);
    particles.vector(fields::pressure_force);
    particles.scalar(fields::depth);
    static constexpr FieldInfo warm{"warm", Rank::vector, unit::none, "for this test",
                                    initial_value::constant(3.5)};
    particles.vector(warm);
    add(particles, 2);
    const auto& gradient = particles.matrix(fields::deformation_gradient);
    const auto& start = particles.vector(fields::initial_position);
    const auto& reference = particles.scalar(fields::reference_density);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(start[i] == particles.position()[i]);
        CHECK(reference[i] == particles.scalar(fields::density)[i]);
        CHECK(gradient[i] == Mat<Dim>::Identity());
        CHECK(particles.vector(fields::pressure_force)[i].isZero(0));
        CHECK(particles.scalar(fields::depth)[i] == 0);
        CHECK(particles.vector(warm)[i] == Vec<Dim>::Constant(3.5));
    }

    SECTION("those that come later leave the others alone") {
        particles.position()[0].setConstant(-1);
        particles.matrix(fields::deformation_gradient)[1].setConstant(3);
        particles.vector(fields::pressure_force)[1].setConstant(3);
        add(particles, 1);
        CHECK(start[0] == Vec<Dim>::Constant(0.5));
        CHECK(start[2] == Vec<Dim>::Constant(2.5));
        CHECK(gradient[1] == Mat<Dim>::Constant(3));
        CHECK(gradient[2] == Mat<Dim>::Identity());
        CHECK(particles.vector(fields::pressure_force)[1] == Vec<Dim>::Constant(3));
        CHECK(particles.vector(warm)[2] == Vec<Dim>::Constant(3.5));
    }
    SECTION("a field that is asked for late has them, too, and makes the one that it follows") {
        const auto& pressure = particles.scalar(fields::average_pressure);
        REQUIRE(particles.find("pressure"));
        CHECK(pressure[1] == 0);
        auto& velocity = particles.vector(fields::velocity);
        velocity[1].setConstant(7);
        CHECK(particles.vector(fields::average_velocity)[1] == Vec<Dim>::Constant(7));
    }
    SECTION("restored ones as well, until their values are read") {
        particles.restore(4, 4);
        CHECK(gradient[3] == Mat<Dim>::Identity());
        CHECK(reference[0] == 0);
    }
}

TEST_CASE("what a field says of its initial value holds together") {
    for (const FieldInfo* info : fields::all()) {
        INFO(info->name);
        const bool same = info->initial.kind == InitialValue::Kind::same;
        CHECK(same == (info->initial.other != nullptr));
        if (same) {
            CHECK(info->initial.other->rank == info->rank);
            CHECK(info->initial.other->initial.kind == InitialValue::Kind::given);
        }
        if (info->initial.kind == InitialValue::Kind::identity) CHECK(info->rank == Rank::matrix);
        if (info->kind == FieldKind::derived) CHECK(!info->hasInitialValue());
    }
}
