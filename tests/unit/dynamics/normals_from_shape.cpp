// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"
#include "../scene/values.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

/// A rigid box of the lattice.
struct Block {
    Scene<3>& scene;
    Body<3>& body;

    Block(Scene<3>& scene, const std::string& name, const Vec<3>& lower, const Vec<3>& upper)
        : scene(scene), body(scene.wall(name, scene.box(lower, upper))) {
        body.shape = sphinx::geometry::makeBox(lower, upper);
    }
    /// `joined`: with another body.
    void findNormals(const std::string& joined = "") {
        scene
            .method("type: geometry.normals_from_shape, body: " + body.name + ", joined: [" +
                    joined + "]")
            .run({});
    }
    /// That of the particle in the cell (x, y, z).
    Vec<3> normal(int x, int y, int z) {
        return body.particles.vector(fields::normal)[at(x, y, z)];
    }
    double depth(int x, int y, int z) {
        return body.particles.scalar(fields::depth)[at(x, y, z)] / spacing;
    }
    std::size_t at(int x, int y, int z) {
        const Vec<3> place = spacing * (Vec<3>(x, y, z) + Vec<3>::Constant(0.5));
        const std::size_t i = nearest(body, place);
        REQUIRE((body.particles.position()[i] - place).norm() < 1e-9);
        return i;
    }
};

}  // namespace

TEST_CASE("particles of an edge face both sides of it") {
    Scene<3> scene;
    // The faces no longer tie.
    Block block(scene, "block", Vec<3>(0, 0, 0), Vec<3>(0.8, 0.8, 0.8 - 0.03));
    block.findNormals();
    const double half = std::sqrt(0.5);
    CHECK((block.normal(0, 4, 4) - Vec<3>(-1, 0, 0)).norm() < 1e-12);
    CHECK((block.normal(1, 4, 4) - Vec<3>(-1, 0, 0)).norm() < 1e-12);
    CHECK((block.normal(0, 0, 4) - Vec<3>(-half, -half, 0)).norm() < 0.02);
    CHECK((block.normal(7, 4, 0) - Vec<3>(half, 0, -half)).norm() < 0.02);
    CHECK((block.normal(0, 0, 0) - Vec<3>::Constant(-std::sqrt(1.0 / 3))).norm() < 0.02);
    CHECK((block.normal(0, 1, 4) - Vec<3>(-1, 0, 0)).norm() < 1e-12);
    CHECK(block.depth(0, 4, 4) == Approx(0.5));
}

TEST_CASE("where a solid stands on another there is no surface") {
    Scene<3> scene;
    Block block(scene, "block", Vec<3>(0, 0, 0), Vec<3>(0.8, 0.8, 0.8));
    Block floor(scene, "floor", Vec<3>(-1, -1, -0.4), Vec<3>(2, 2, 0));
    block.findNormals();
    CHECK((block.normal(2, 4, 0) - Vec<3>(0, 0, -1)).norm() < 1e-12);
    block.findNormals("floor");
    for (int row = 0; row < 2; ++row) {
        const Vec<3> n = block.normal(row, 4, 0);
        CHECK(n[0] < -0.8);  // the corner between both is smoothed
        CHECK(n[2] >= 0);
        CHECK(block.depth(row, 4, 0) == Approx(row + 0.5).margin(0.4));
    }
    // The floor ends at the block: beside it, it faces up.
    floor.findNormals("block");
    CHECK((floor.normal(-5, 4, -1) - Vec<3>(0, 0, 1)).norm() < 1e-12);
    CHECK((floor.normal(-1, 4, -1) - Vec<3>(0, 0, 1)).norm() < 0.3);
}
