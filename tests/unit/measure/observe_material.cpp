// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_material.h"

#include "../memory_archive.h"
#include "../scene/scene.h"
#include "../scene/values.h"
#include "core/errors.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace sphinx;
using namespace sphinx::measure;
using namespace sphinx::test;

namespace {

/// A block, and an observer of one point in it that follows the material.
struct Block : Scene<2> {
    bodies::Body<2>& block = fluid("block", box(Vec<2>(0, 0), Vec<2>(1, 1)));
    bodies::Body<2>& probe = observer({Vec<2>(0.62, 0.43)}, {&block});
    MaterialWeights<2> weights{probe, relations, world.domain};

    void move(const Vec<2>& by) {
        for (std::size_t i = 0; i < block.size(); ++i) block.particles.position()[i] += by;
        ++block.version;
    }
    /// Ids with their weights, in the order of ids.
    std::vector<std::pair<std::int64_t, double>> parts() {
        std::vector<std::pair<std::int64_t, double>> parts;
        for (const ParticleWeight& one : weights.of(0))
            parts.emplace_back(block.particles.id()[one.particle], one.weight);
        std::sort(parts.begin(), parts.end());
        return parts;
    }
    void sort() {
        block.particles.permute(reversed(block));
        ++block.version;
    }
};

}  // namespace

TEST_CASE("a point of the material starts where it was put and moves with the particles") {
    Block scene;
    scene.weights.update();
    CHECK((scene.weights.position(0) - Vec<2>(0.62, 0.43)).norm() < 1e-14);
    CHECK(scene.weights.coverage(0) == Approx(1).epsilon(0.012));
    scene.move(Vec<2>(5, -3));
    scene.weights.update();
    CHECK((scene.weights.position(0) - Vec<2>(5.62, -2.57)).norm() < 1e-13);
    CHECK(scene.probe.particles.position()[0] == Vec<2>(0.62, 0.43));
}

TEST_CASE("a point of the material keeps its particles when they are sorted") {
    Block scene;
    scene.weights.update();
    const auto before = scene.parts();
    REQUIRE(before.size() > 10);
    scene.move(Vec<2>(0.35, 0));
    scene.sort();
    scene.weights.update();
    CHECK(scene.parts() == before);
}

TEST_CASE("a point of the material does without particles that were removed") {
    Block scene;
    scene.weights.update();
    const double coverage = scene.weights.coverage(0);
    const ParticleWeight lost = scene.weights.of(0).front();
    const auto before = scene.parts();
    scene.block.particles.remove({lost.particle});
    ++scene.block.version;
    scene.weights.update();
    CHECK(scene.parts().size() == before.size() - 1);
    CHECK(scene.weights.coverage(0) == Approx(coverage * (1 - lost.weight)));
    double sum = 0;
    for (const ParticleWeight& one : scene.weights.of(0)) sum += one.weight;
    CHECK(sum == Approx(1));

    std::vector<Index> all(scene.block.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
    scene.block.particles.remove(all);
    ++scene.block.version;
    scene.weights.update();
    CHECK(scene.weights.of(0).empty());
    CHECK(scene.weights.coverage(0) == 0);
    CHECK(std::isnan(scene.weights.position(0)[0]));
}

TEST_CASE("a resumed run knows the particles of a point of the material") {
    Block scene;
    MemoryArchive fresh;
    scene.weights.transfer(fresh);  // not attached yet
    scene.weights.update();
    scene.move(Vec<2>(0.5, 0));
    scene.sort();
    scene.weights.update();
    const auto parts = scene.parts();
    const Vec<2> position = scene.weights.position(0);
    MemoryArchive archive;
    scene.weights.transfer(archive);

    Block resumed;
    resumed.move(Vec<2>(0.5, 0));
    resumed.sort();
    archive.is_loading = true;
    resumed.weights.transfer(archive);
    resumed.weights.update();
    CHECK(resumed.parts() == parts);
    CHECK(resumed.weights.position(0) == position);

    SECTION("a state from before the first row attaches at the first row") {
        Block again;
        fresh.is_loading = true;
        again.weights.transfer(fresh);
        again.weights.update();
        CHECK(again.parts() == parts);
    }
    SECTION("an observer that has other points now is attached anew") {
        bodies::Body<2>& other =
            resumed.observer({Vec<2>(1, 0.5), Vec<2>(1.2, 0.5)}, {&resumed.block});
        MaterialWeights<2> weights(other, resumed.relations, resumed.world.domain);
        weights.transfer(archive);
        weights.update();
        CHECK((weights.position(0) - Vec<2>(1, 0.5)).norm() < 1e-14);
    }
    SECTION("a damaged state is refused") {
        using Integers = std::vector<std::int64_t>;
        const auto refused = [&](const std::string& name, auto change) {
            MemoryArchive damaged(archive.saved);
            change(std::get<Integers>(damaged.saved.at(name)));
            CHECK_THROWS_AS(resumed.weights.transfer(damaged), FileError);
        };
        refused("id", [](Integers& values) { values.pop_back(); });
        refused("body", [](Integers& values) { values.back() = 1; });
        refused("body", [](Integers& values) { values.back() = -1; });
        refused("anchors", [](Integers& values) { ++values.back(); });
        refused("anchors", [](Integers& values) { values.back() = -1; });
        refused("anchors", [](Integers& values) { values.push_back(0); });
    }
}

TEST_CASE("a point of the material passes through a periodic boundary") {
    Block scene;
    scene.repeat(0, Vec<2>(-1, -1), Vec<2>(2, 2));
    scene.weights.update();
    scene.move(Vec<2>(1.4, 0));
    int beyond = 0;
    for (std::size_t i = 0; i < scene.block.size(); ++i) {
        double& x = scene.block.particles.position()[i][0];
        if (x >= 2) x -= 3, ++beyond;
    }
    REQUIRE(beyond > 0);
    scene.weights.update();
    const Vec<2> expected(2.02, 0.43);
    CHECK(scene.world.domain.difference(scene.weights.position(0), expected).norm() < 1e-13);
}
