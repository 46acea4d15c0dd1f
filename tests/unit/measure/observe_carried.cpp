// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "measure/observe_carried.h"

#include "../scene/outputs.h"
#include "../scene/values.h"
#include "core/errors.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::measure;
using namespace sphinx::test;

namespace {

/// Water, a lid on it that moves, and an observer that the lid carries.
struct Lid : Scene<2> {
    bodies::Body<2>& water = fluid("water", box(Vec<2>(-2, -2), Vec<2>(2, 2)));
    bodies::Body<2>& lid = wall("lid", box(Vec<2>(-1, 2), Vec<2>(1, 2.4)));
    bodies::Body<2>& probe = observer({Vec<2>(0.62, 0.43), Vec<2>(-0.4, 1)}, {&water});
    const particles::Field<Vec<2>>& start = lid.particles.vector(fields::initial_position);
    io::Follower<2> follower{&probe, &lid};

    template <class Motion>
    void move(Motion motion) {
        for (std::size_t i = 0; i < lid.size(); ++i) lid.particles.position()[i] = motion(start[i]);
        ++lid.version;
    }
};

}  // namespace

TEST_CASE("points that a solid carries look where it has brought them") {
    Lid scene;
    const Mat<2> Q = Eigen::Rotation2Dd(0.6).toRotationMatrix();
    const auto motion = [&](const Vec<2>& R) -> Vec<2> { return Q * R + Vec<2>(0.1, -0.7); };
    CarriedWeights<2> carried(scene.probe, scene.follower, scene.relations, scene.world);
    carried.update();
    CHECK(carried.position(0) == Vec<2>(0.62, 0.43));
    scene.move(motion);
    carried.update();
    bodies::Body<2>& there =
        scene.observer({motion(Vec<2>(0.62, 0.43)), motion(Vec<2>(-0.4, 1))}, {&scene.water});
    ObserveWeights<2> fixed(there, scene.relations);
    fixed.update();
    for (std::size_t point = 0; point < 2; ++point) {
        CHECK((carried.position(point) - fixed.position(point)).norm() < 1e-14);
        CHECK(carried.coverage(point) == Approx(fixed.coverage(point)).epsilon(1e-9));
        CHECK(carried.of(point).size() == fixed.of(point).size());
    }
    // Back where it began.
    scene.move([](const Vec<2>& R) { return R; });
    carried.update();
    CHECK(carried.position(1) == Vec<2>(-0.4, 1));
}

TEST_CASE("nothing can follow a solid that changes its shape") {
    Lid scene;
    CarriedWeights<2> carried(scene.probe, scene.follower, scene.relations, scene.world);
    scene.move([](const Vec<2>& R) { return Vec<2>(R[0], R[1] + 0.1 * R[0]); });
    CHECK_THROWS_WITH(carried.update(),
                      "the points of probe cannot follow lid: it has not moved as a rigid body");
}
