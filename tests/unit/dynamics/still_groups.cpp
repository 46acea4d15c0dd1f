// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/still_groups.h"

#include "../scene/stepper.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <set>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

/// A block and how often its sums are made.
struct Watched {
    Scene<2> scene;
    Body<2>& body;
    Field<Vec<2>>& velocity;
    Field<Vec<2>>& position;
    Field<Mat<2>>& stress;
    ReferenceRelation<2>& relation;
    solid::StillGroups<2> still;
    solid::Planes<2> planes;

    Watched()
        : body(scene.elastic("block", scene.lattice(30, 0.2))),
          velocity(body.particles.vector(fields::velocity)),
          position(body.particles.position()),
          stress(body.particles.matrix(fields::corrected_stress)),
          relation(scene.relations.reference(body, body)) {
        scene.relations.build(relation);
        still.begin(body.size());
        still.setNeighbors(relation.list, body.size());
        planes.resize(body.size());
    }
    /// The groups of which the sum is made in a step.
    std::set<std::size_t> made() {
        each([&](const Group& group) {
            const MatOf<2, Wide> T = load(stress, group);
            still.look(velocity, position, T, planes, group);
            planes.store(T, group);
        });
        std::set<std::size_t> groups;
        each([&](const Group& group) {
            still.sumOf(group, [&]() -> VecOf<2, Wide> {
                groups.insert(group.number());
                return VecOf<2, Wide>::Zero();
            });
        });
        return groups;
    }
    /// The group of the particle, and those that have a neighbor in it.
    std::set<std::size_t> near(std::size_t particle) {
        const std::size_t own = particle / lane_count;
        std::set<std::size_t> groups{own};
        for (std::size_t i = 0; i < body.size(); ++i)
            relation.list.forEach(i, [&](Index j, double) {
                if (j / lane_count == own) groups.insert(i / lane_count);
            });
        return groups;
    }
    template <class F>
    void each(F&& f) {
        for (std::size_t number = 0; number < groupCount(body.size()); ++number)
            f(groupOf(number, body.size()));
    }
};

template <class Set>
bool holdsAll(const Set& all, const Set& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

}  // namespace

TEST_CASE("sums over what stands still are made once, and again near what has changed") {
    Watched watched;
    const std::size_t groups = groupCount(watched.body.size());
    CHECK(watched.made().size() == groups);
    CHECK(watched.made().empty());

    const std::size_t particle = watched.body.size() / 2;
    const auto checkChange = [&] {
        const std::set<std::size_t> made = watched.made();
        CHECK(holdsAll(made, watched.near(particle)));
        CHECK(made.size() < groups / 2);
    };
    SECTION("its place") {
        watched.position[particle][1] += 1e-12;
        checkChange();
        CHECK(watched.made().empty());
    }
    SECTION("its stress") {
        watched.stress[particle](1, 0) += 1e-12;
        checkChange();
        CHECK(watched.made().empty());
    }
    SECTION("what moves changes all the time") {
        watched.velocity[particle][0] = 1e-12;
        checkChange();
        checkChange();
        watched.velocity[particle][0] = 0;  // it may have come from elsewhere
        checkChange();
        CHECK(watched.made().empty());
    }
    SECTION("what adds to its stress afterwards") {
        const std::size_t own = particle / lane_count;
        watched.still.change(own);
        bool made = false;
        const Group group = groupOf(own, watched.body.size());
        watched.still.sumOf(group, [&]() -> VecOf<2, Wide> {
            made = true;
            return VecOf<2, Wide>::Zero();
        });
        CHECK(made);
    }
    SECTION("groups with neighbors in another body") {
        watched.still.excludeNeighborsOf(watched.relation.list);
        watched.position[particle][1] += 1e-12;
        watched.made();
        CHECK(holdsAll(watched.made(), watched.near(particle)));
    }
}

namespace {

/// All that moves after some steps of a block of which a part is held. `anew`: with a method in
/// each step that knows nothing of the last one.
template <int Dim>
std::vector<double> held(bool anew) {
    Scene<Dim> scene;
    const int n = Dim == 2 ? 30 : 12;
    Body<Dim>& body = scene.elastic("block", scene.lattice(n, 0.2));
    scene.part(body, "base", [&](const Vec<Dim>& R) { return R[0] < 0.7 * spacing * n; });
    ParticleSet<Dim>& p = body.particles;
    for (std::size_t i = 0; i < body.size(); ++i)
        if (p.position()[i][0] > 0.8 * spacing * n)
            p.vector(fields::velocity)[i] = scene.random.template vector<Dim>(1);
    const MadeMethod<Dim> fix = scene.method("type: constraint.fix, part: block.base");
    Stepper<Dim> stepper(scene, body, {&fix});
    for (int step = 0; step < 30; ++step) {
        if (anew) {
            stepper.relaxation = scene.method("type: solid.stress_relaxation, body: block");
            stepper.relaxation->announce();
            stepper.relaxation->prepare();
        }
        // Late enough for all to be known, a load reaches what is held.
        if (step == 20) p.vector(fields::pressure_force)[0][1] = 1e-3;
        stepper.step(1e-4, {}, {&fix});
    }
    std::vector<double> state;
    for (const auto& info : {fields::position, fields::velocity, fields::acceleration,
                             fields::deformation_gradient, fields::deformation_rate}) {
        const particles::FieldBase& field = *p.find(info.name);
        const std::size_t count = body.size() * static_cast<std::size_t>(field.components());
        state.insert(state.end(), field.numbers(), field.numbers() + count);
    }
    return state;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("what stands still goes on as if its sums were made in every step", "",
                       ((int Dim), Dim), 2, 3) {
    const std::vector<double> known = held<Dim>(false);
    const std::vector<double> anew = held<Dim>(true);
    CHECK(std::memcmp(known.data(), anew.data(), sizeof(double) * known.size()) == 0);
}
