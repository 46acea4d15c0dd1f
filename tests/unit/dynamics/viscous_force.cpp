// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

#include "../scene/scene.h"
#include "../scene/values.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double viscosity = 0.3;

/// Fluid whose particles have the given places and velocities, and the force on it.
template <int Dim>
struct Sample : Scene<Dim> {
    template <class Velocity>
    Sample(const std::vector<Vec<Dim>>& points, Velocity&& velocity, const std::string& form,
           Precision precision = Precision::full)
        : water(this->fluid("water", points, {.viscosity = viscosity})) {
        this->world.precision = precision;
        const auto force = this->method("type: fluid.viscous_force, body: water, form: " + form);
        give(water, fields::velocity, velocity);
        this->relations.update({&water});
        force.run({});
    }
    const Vec<Dim>& acceleration(std::size_t i) {
        return water.particles.vector(fields::external_acceleration)[i];
    }

    Body<Dim>& water;
};

/// A cube of (2n + 1)^Dim lattice points around the origin, which is the middle one of them; in
/// each row, the points of one x for each y, displaced by `place` of the row along x.
template <int Dim, class Place>
std::vector<Vec<Dim>> rows(int n, Place&& place) {
    std::vector<Vec<Dim>> points;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i) {
                Vec<Dim> x = Vec<Dim>::Zero();
                x[0] = spacing * (i + place(j));
                x[1] = spacing * j;
                if constexpr (Dim == 3) x[2] = spacing * k;
                points.push_back(x);
            }
    return points;
}

/// What the force is of the exact one, at the middle particle of a flow along x with u = y^2.
template <int Dim>
double shareOfViscosity(const std::vector<Vec<Dim>>& points, const std::string& form,
                        Precision precision = Precision::full) {
    Sample<Dim> fluid(
        points, [](const Vec<Dim>& x) -> Vec<Dim> { return x[1] * x[1] * Vec<Dim>::Unit(0); }, form,
        precision);
    return fluid.acceleration(points.size() / 2)[0] / (2 * viscosity / density);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("on a lattice the laplacian is exact", "", ((int Dim), Dim), 2, 3) {
    const auto lattice = rows<Dim>(5, [](int) { return 0; });
    CHECK(std::abs(shareOfViscosity<Dim>(lattice, "laplacian") - 1) < list_error);
    CHECK(std::abs(shareOfViscosity<Dim>(lattice, "laplacian", Precision::single) - 1) <
          single_error);
}

TEST_CASE("rows that glide past each other keep the laplacian, not the central force") {
    const auto all = [](const std::string& form, double low, double high) {
        for (double glide = 0; glide < 1; glide += 0.125) {
            INFO("each row " << glide << " spacings ahead");
            const auto place = [=](int j) { return glide * j - std::round(glide * j); };
            const double share = shareOfViscosity<2>(rows<2>(9, place), form);
            CHECK(share > low);
            CHECK(share < high);
        }
    };
    all("laplacian", 0.999, 1.001);
    all("central", 0.82, 0.94);
}

TEST_CASE("where sixfold symmetry makes neighbors alike the central force is exact") {
    const double edge = std::sqrt(2 / std::sqrt(3.0));
    std::vector<Vec<2>> points;
    for (int j = -9; j <= 9; ++j)
        for (int i = -9; i <= 9; ++i)
            points.push_back(edge * spacing * Vec<2>(i + 0.5 * j, 0.5 * std::sqrt(3.0) * j));
    CHECK(std::abs(shareOfViscosity<2>(points, "central") - 1) < list_error);
}

TEST_CASE("a free drop that turns") {
    const double radius = 4;
    const double turn = 3;  // speed of rotation
    std::vector<Vec<2>> points;
    for (const Vec<2>& x : rows<2>(40, [](int) { return 0; }))
        if (x.norm() < radius) points.push_back(x);
    const auto rigid = [=](const Vec<2>& x) -> Vec<2> { return {-turn * x[1], turn * x[0]}; };
    const double scale = viscosity / density * turn / spacing;
    const auto torque = [&](Sample<2>& fluid) {
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec<2>& a = fluid.acceleration(i);
            sum += density * spacing * spacing * (points[i][0] * a[1] - points[i][1] * a[0]);
        }
        return sum;
    };

    SECTION("feels no central force") {
        Sample<2> fluid(points, rigid, "central");
        for (std::size_t i = 0; i < points.size(); ++i)
            CHECK(fluid.acceleration(i).norm() < list_error * scale);
    }
    SECTION("is slowed by the laplacian, but only at its surface") {
        Sample<2> fluid(points, rigid, "laplacian");
        for (std::size_t i = 0; i < points.size(); ++i)
            if (points[i].norm() < radius - 4 * spacing)
                CHECK(fluid.acceleration(i).norm() < list_error * scale);
        // -2 mu turn area: the angular momentum decays at the rate 4 nu / radius^2. At the surface
        // the sums of the kernel miss the neighbors of a strip of half a spacing or so.
        const double area = std::numbers::pi * radius * radius;
        CHECK(torque(fluid) == Approx(-2 * viscosity * turn * area).epsilon(0.05));
    }
}
