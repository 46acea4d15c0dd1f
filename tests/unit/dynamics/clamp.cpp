// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

#include "../scene/stepper.h"
#include "dynamics/constraint/mirror_images.h"
#include "dynamics/solid/internal_energy.h"

#include <catch2/catch.hpp>

#include <map>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

/// A body that is clamped where R_0 < depth: `shift` spacings beyond the middle between two rows.
template <int Dim>
struct Clamped {
    const double depth;
    Scene<Dim> scene;
    Body<Dim>& body;
    MadeMethod<Dim> clamp;
    Stepper<Dim> stepper;

    explicit Clamped(double jitter, double damping = 0, double shift = 0)
        : depth((3 + shift) * spacing),
          body(scene.elastic("block", scene.lattice(blockSize(), jitter), {.damping = damping})),
          clamp(scene.method("type: constraint.clamp, part: " + base(body))),
          stepper(scene, body, {&clamp}) {}

    static std::array<int, Dim> blockSize() {
        std::array<int, Dim> n;
        n.fill(Dim == 2 ? 6 : 5);
        n[0] = 9;
        return n;
    }
    std::string base(Body<Dim>& whole) {
        scene.addPart(whole, "base", [&](const Vec<Dim>& R) { return R[0] < depth; });
        Vec<Dim> upper = Vec<Dim>::Constant(10);
        upper[0] = depth;
        whole.parts.back().shape = geometry::makeBox<Dim>(Vec<Dim>::Constant(-10), upper);
        return "block.base";
    }
    auto timeStep() { return scene.timeStep("type: solid.acoustic_time_step, body: block"); }
    Field<Vec<Dim>>& vectors(const particles::FieldInfo& info) {
        return body.particles.vector(info);
    }
    /// Velocities of all that are no images; the images follow.
    template <class Velocity>
    void setVelocity(Velocity&& velocity) {
        for (std::size_t i = 0; i < body.size(); ++i)
            vectors(fields::velocity)[i] =
                body.elastic().isImage(i) ? Vec<Dim>::Zero().eval() : velocity(i);
        clamp.run({.is_start = true});
    }
    /// Displaces likewise; F from there, all at rest. Returns the energy.
    template <class Displacement>
    double displace(Displacement&& displacement) {
        setVelocity(displacement);
        for (std::size_t i = 0; i < body.size(); ++i) {
            body.particles.position()[i] =
                vectors(fields::initial_position)[i] + vectors(fields::velocity)[i];
            vectors(fields::velocity)[i].setZero();
        }
        stepper.start();
        return solid::internalEnergy(body, scene.relations);
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a clamped body deforms evenly up to the surface of its clamp", "",
                       ((int Dim), Dim), 2, 3) {
    Clamped<Dim> block(0.2, 0, GENERATE(0, 0.2, 0.4));
    const Vec<Dim> stretch = block.scene.random.template vector<Dim>(1);
    block.setVelocity([&](std::size_t i) -> Vec<Dim> {
        return (block.vectors(fields::initial_position)[i][0] - block.depth) * stretch;
    });
    block.stepper.start();
    Mat<Dim> rate = Mat<Dim>::Zero();
    rate.col(0) = stretch;
    for (std::size_t i = 0; i < block.body.size(); ++i) {
        if (block.body.elastic().share(i) == 0) continue;
        const Mat<Dim>& found = block.body.particles.matrix(fields::deformation_rate)[i];
        CHECK((found - rate).cwiseAbs().maxCoeff() < 1e-11);
    }
}

TEMPLATE_TEST_CASE_SIG("forces in a clamped body are those of its energy", "", ((int Dim), Dim), 2,
                       3) {
    Clamped<Dim> block(0.1, 0, GENERATE(0, 0.2, 0.4));
    Body<Dim>& body = block.body;
    std::vector<Vec<Dim>> u(body.size()), du(body.size());
    for (Vec<Dim>& v : u) v = block.scene.random.template vector<Dim>(0.05 * spacing);
    for (Vec<Dim>& v : du) v = block.scene.random.template vector<Dim>(spacing);
    const auto energy = [&](double step) {
        return block.displace([&](std::size_t i) -> Vec<Dim> { return u[i] + step * du[i]; });
    };
    const double step = 1e-5;
    const double slope = (energy(step) - energy(-step)) / (2 * step);
    energy(0);
    block.stepper.step(1e-12, {}, {&block.clamp});
    double power = 0;
    Vec<Dim> total = Vec<Dim>::Zero();
    for (std::size_t i = 0; i < body.size(); ++i) {
        if (body.elastic().isImage(i)) continue;
        const Vec<Dim> force =
            body.particles.scalar(fields::mass)[i] * block.vectors(fields::acceleration)[i];
        power += force.dot(du[i]);
        total += force;
    }
    CHECK(power == Approx(-slope).epsilon(1e-6));
    CHECK((block.clamp.load().force - total).norm() < 1e-10 * total.norm());
}

TEST_CASE("the reaction of a clamped body is its weight when it has come to rest") {
    Clamped<2> block(0, 2);
    const auto gravity =
        block.scene.method("type: force.gravity, body: block, acceleration: [-10, 0]");
    const auto time_step = block.timeStep();
    while (block.stepper.clock.time < 15)
        block.stepper.step(time_step->estimate(), {&gravity}, {&block.clamp});
    Load<2> weight;
    for (std::size_t i = 0; i < block.body.size(); ++i)
        weight.add(block.body.particles.position()[i],
                   Vec<2>(-10 * block.body.particles.scalar(fields::mass)[i], 0));
    const Load<2> reaction = block.clamp.load();
    CHECK((reaction.force + weight.force).norm() < 1e-6 * weight.force.norm());
    CHECK((reaction.moment + weight.moment).norm() < 1e-6 * weight.moment.norm());
}

TEST_CASE("a clamped body moves as before when its particles change places in memory") {
    Clamped<2> kept(0.2, 0, 0.2), mixed(0.2, 0, 0.2);
    const auto run = [](Clamped<2>& block) {
        for (int k = 0; k < 20; ++k) block.stepper.step(1e-3, {}, {&block.clamp});
    };
    for (Clamped<2>* block : {&kept, &mixed}) {
        const auto& start = block->vectors(fields::initial_position);
        block->setVelocity([&](std::size_t i) { return Vec<2>(0, start[i][0] - block->depth); });
        block->stepper.start();
        run(*block);
    }
    const std::size_t n = kept.body.size();
    AlignedVector<Index> order(n);
    for (std::size_t k = 0; k < n; ++k) order[k] = static_cast<Index>((k * 5 + 3) % n);
    REQUIRE(n % 5 != 0);
    mixed.body.particles.permute(order);
    run(kept);
    run(mixed);
    double moved = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = order[k];
        const Vec<2>& expected = kept.body.particles.position()[i];
        CHECK((mixed.body.particles.position()[k] - expected).norm() < 1e-13);
        moved = std::max(moved, (expected - kept.vectors(fields::initial_position)[i]).norm());
    }
    CHECK(moved > 1e-3);
    CHECK((mixed.clamp.load().force - kept.clamp.load().force).norm() <
          1e-11 * kept.clamp.load().force.norm());
}

TEST_CASE("what a clamp covers whole has no say in the time step") {
    Clamped<2> block(0);
    const auto time_step = block.timeStep();
    block.stepper.start();
    const double step = time_step->estimate();
    auto& gradient = block.body.particles.matrix(fields::deformation_gradient);
    for (std::size_t i = 0; i < block.body.size(); ++i)
        if (block.body.elastic().share(i) == 0) gradient[i] = Vec<2>(10, 1).asDiagonal();
    CHECK(time_step->estimate() == step);
    gradient[block.body.size() - 1] = Vec<2>(10, 1).asDiagonal();
    CHECK(time_step->estimate() < 0.5 * step);
}

TEST_CASE("images stand behind the surface of the clamp, in its corners behind both") {
    Scene<2> scene;
    Body<2>& body = scene.elastic("block", scene.lattice(8));
    const double depth = 3 * spacing;
    const geometry::ShapePointer<2> rest =
        geometry::makeBox<2>(Vec<2>::Constant(depth), Vec<2>::Constant(6 * spacing));
    scene.addPart(body, "frame", [&](const Vec<2>& R) { return !rest->contains(R); });
    body.parts.back().shape = geometry::makeDifference<2>(
        {geometry::makeBox<2>(Vec<2>::Constant(-10), Vec<2>::Constant(10)), rest});
    const Part<2> frame = scene.part("block.frame");
    scene.method("type: constraint.clamp, part: block.frame")->announce();
    bodies::findShares(body);
    auto& relation = scene.relations.reference(body, body);
    scene.relations.build(relation);
    const auto links =
        constraint::mirrorImages(frame, frame.images(), relation, scene.world.domain);
    std::map<std::pair<int, int>, std::pair<int, int>> found;
    for (const auto& link : links) {
        CHECK(link.weight == -1);
        const auto cell = [&](Index i) {
            const Vec<2> place = body.particles.position()[i] / spacing;
            return std::pair(static_cast<int>(place[0]), static_cast<int>(place[1]));
        };
        CHECK(found.emplace(cell(link.image), cell(link.real)).second);
    }
    using Cell = std::pair<int, int>;
    // Beside the square of 3 x 3, two rows within reach on each side, one particle in each corner
    // at a smoothing length of 1.15 spacings.
    CHECK(found.at(Cell(2, 4)) == Cell(3, 4));
    CHECK(found.at(Cell(1, 4)) == Cell(4, 4));
    CHECK(found.at(Cell(6, 3)) == Cell(5, 3));
    CHECK(found.at(Cell(2, 2)) == Cell(3, 3));
    CHECK(found.at(Cell(6, 6)) == Cell(5, 5));
    CHECK(found.count(Cell(0, 4)) == 0);
}
