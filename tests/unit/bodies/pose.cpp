// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "bodies/pose.h"

#include "../scene/bodies.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::test;

namespace {

template <int Dim>
Mat<Dim> someTurn(double angle) {
    if constexpr (Dim == 2)
        return Eigen::Rotation2Dd(angle).toRotationMatrix();
    else
        return Eigen::AngleAxisd(angle, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();
}

template <int Dim>
struct Solid : Bodies<Dim> {
    bodies::Body<Dim>& solid = this->wall("solid", this->box(Vec<Dim>::Zero(), Vec<Dim>::Ones()));
    const particles::Field<Vec<Dim>>& start = solid.particles.vector(fields::initial_position);

    template <class Motion>
    bodies::Pose<Dim> after(Motion motion, const bodies::BodyPart<Dim>* part = nullptr) {
        for (std::size_t i = 0; i < solid.size(); ++i)
            solid.particles.position()[i] = motion(start[i]);
        return bodies::poseOf(solid, part, this->world.domain);
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("the pose of a body that was turned and shifted", "", ((int Dim), Dim), 2,
                       3) {
    Solid<Dim> s;
    const Vec<Dim> shift = Vec<Dim>::LinSpaced(Dim, -3, 2);
    const Vec<Dim> outside = Vec<Dim>::LinSpaced(Dim, 2, -1);
    for (const double angle : {0.0, 1e-9, 0.4, 2.0, 3.14159, -1.7}) {
        const Mat<Dim> Q = someTurn<Dim>(angle);
        const auto pose = s.after([&](const Vec<Dim>& R) -> Vec<Dim> { return Q * R + shift; });
        CHECK((pose.turn - Q).norm() < 1e-14);
        CHECK((pose(outside) - Q * outside - shift).norm() < 1e-14);
        CHECK(pose.misfit < 1e-14);
    }
}

TEST_CASE("a body that has not moved is where it was, to the last bit") {
    Solid<3> s;
    const auto pose = s.after([](const Vec<3>& R) { return R; });
    CHECK(pose(Vec<3>(0.1, 0.7, 1.3)) == Vec<3>(0.1, 0.7, 1.3));
    Bodies<2> b;
    CHECK(bodies::poseOf<2>(b.wall("still", {Vec<2>(1, 2)}), nullptr,
                            b.world.domain)(Vec<2>(0.1, 0.3)) == Vec<2>(0.1, 0.3));
}

TEST_CASE("a body that is no longer what it was does not fit") {
    Solid<2> s;
    CHECK(s.after([](const Vec<2>& R) { return Vec<2>(1.01 * R[0], R[1]); }).misfit ==
          Approx(0.0045).epsilon(0.01));
    Solid<3> mirrored;
    CHECK(mirrored.after([](const Vec<3>& R) { return Vec<3>(-R[0], R[1], R[2]); }).misfit > 0.4);
}

TEST_CASE("a body that has moved across a periodic side") {
    Solid<2> s;
    s.repeat(0, Vec<2>(-0.5, -5), Vec<2>(2.5, 5));
    const Mat<2> Q = someTurn<2>(0.5);
    const Vec<2> shift(7.9, 0.3);
    const auto pose = s.after(
        [&](const Vec<2>& R) -> Vec<2> { return s.world.domain.wrapped(Vec<2>(Q * R + shift)); });
    CHECK(pose.misfit < 1e-14);
    const Vec<2> point(0.2, 1.4);
    CHECK((s.world.domain.wrapped(pose(point)) - s.world.domain.wrapped(Vec<2>(Q * point + shift)))
              .norm() < 1e-13);
}

TEST_CASE("in 3D a row of particles does not tell how it has turned") {
    Bodies<3> b;
    bodies::Body<3>& row = b.wall("row", {Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(2, 0, 0)});
    row.particles.vector(fields::initial_position);
    for (std::size_t i = 0; i < row.size(); ++i) row.particles.position()[i][1] += 1;
    CHECK(std::isnan(bodies::poseOf<3>(row, nullptr, b.world.domain).misfit));
}
