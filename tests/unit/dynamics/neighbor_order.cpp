// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/neighbor_order.h"

#include "../scene/stepper.h"
#include "core/errors.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

using namespace sphinx;
using namespace sphinx::test;

namespace {

/// A block whose particles stand where `place` says of their initial position.
template <int Dim>
struct Block {
    Scene<Dim> scene;
    bodies::Body<Dim>& body = scene.elastic("block", scene.lattice(Dim == 2 ? 8 : 5, 0));
    Stepper<Dim> stepper{scene, body};
    dynamics::solid::NeighborOrder<Dim> order{scene.world, scene.relations, body};

    template <class Place>
    void set(Place&& place) {
        for (std::size_t i = 0; i < body.size(); ++i)
            body.particles.position()[i] =
                place(i, body.particles.vector(fields::initial_position)[i]);
        stepper.start();  // F of these positions
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a deformation that F sees changes no places, however large", "",
                       ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    for (int k = 0; k < 20; ++k) {
        Mat<Dim> A = block.scene.random.template matrix<Dim>(3);
        if (A.determinant() < 0) A.col(0) *= -1;
        block.set([&](std::size_t, const Vec<Dim>& R) -> Vec<Dim> { return A * R; });
        CHECK_NOTHROW(block.order.check({}));
    }
}

TEST_CASE("a bar that turns by an eighth between its rows keeps its order") {
    Block<3> block;
    block.set([&](std::size_t, const Vec<3>& R) -> Vec<3> {
        return Eigen::AngleAxisd(R[0] / spacing * M_PI / 4, Vec<3>::UnitX()) * R;
    });
    CHECK_NOTHROW(block.order.check({}));
}

TEMPLATE_TEST_CASE_SIG("rows that pass each other are found, though det F stays positive", "",
                       ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    const auto zigzag = [&](double size) {
        block.set([&](std::size_t, const Vec<Dim>& R) -> Vec<Dim> {
            const bool odd = std::lround(std::floor(R[0] / spacing)) % 2 != 0;
            return R + (odd ? size : -size) * spacing * Vec<Dim>::Unit(0);
        });
    };
    zigzag(0.4);
    CHECK_NOTHROW(block.order.check({}));
    zigzag(0.7);
    CHECK_THROWS_AS(block.order.check({}), PhysicsError);
    CHECK_THROWS_WITH(block.order.check({}), Catch::Contains("of block at (") &&
                                                 Catch::Contains("have changed places, time 0"));
}

TEST_CASE("pairs are looked at again before slow particles can have changed places") {
    Block<2> block;
    int steps = 0;
    const auto drift = [&] {
        for (; steps < 100; ++steps) {
            block.set([&](std::size_t, const Vec<2>& R) -> Vec<2> {
                const bool odd = std::lround(std::floor(R[0] / spacing)) % 2 != 0;
                return R + (odd ? 0.01 : -0.01) * steps * spacing * Vec<2>::Unit(0);
            });
            block.order.check({});
        }
    };
    CHECK_THROWS_AS(drift(), PhysicsError);
    CHECK(steps > 45);  // two rows meet at 50
    CHECK(steps < 60);
}
