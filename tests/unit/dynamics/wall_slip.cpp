// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"
#include "../scene/values.h"
#include "dynamics/fluid/solid_load.h"

#include <catch2/catch.hpp>

#include <optional>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double viscosity = 0.3;
constexpr double shear = 0.7;
constexpr double length = 1.2;

/// Water on a wall, both repeated along x, with the velocity u along it.
template <int Dim>
struct Stream : Scene<Dim> {
    template <class Speed>
    Stream(const std::string& slip, const std::string& form, Speed&& u) {
        this->world.precision = Precision::full;
        this->repeat(0, Vec<Dim>::Zero(), Vec<Dim>::Constant(length));
        water = &this->fluid("water", this->box(Vec<Dim>::Zero(), Vec<Dim>::Constant(length)),
                             {.viscosity = viscosity});
        Vec<Dim> lower = Vec<Dim>::Zero();
        Vec<Dim> upper = Vec<Dim>::Constant(length);
        lower[1] = -4 * spacing;
        upper[1] = 0;
        wall = &Scene<Dim>::wall("floor", this->box(lower, upper), Face{});
        water->sees = {water, wall};
        give(*water, fields::velocity,
             [&](const Vec<Dim>& x) -> Vec<Dim> { return u(x[1]) * Vec<Dim>::Unit(0); });
        force.emplace(this->method("type: fluid.viscous_force, body: water, wall: " + slip +
                                   ", form: " + form));
        // As fsi.viscous_force and outputs of forces ask for it.
        list = &this->relations.flow(*water, *wall, {.distance = true});
        this->relations.update({water});
        force->run({});
    }
    Vec<Dim> forceOnWall() const {
        return force->template as<fluid::SolidLoad<Dim>>()
            .loadOn(*wall, list->list, Vec<Dim>::Zero())
            .force;
    }
    const Field<Vec<Dim>>& acceleration() const {
        return water->particles.vector(fields::external_acceleration);
    }
    /// Acceleration of the particle nearest to y, in the middle of the others.
    Vec<Dim> accelerationAt(double y) const {
        Vec<Dim> place = Vec<Dim>::Constant(length / 2);
        place[1] = y;
        return acceleration()[nearest(*water, place)];
    }

    Body<Dim>* water;
    Body<Dim>* wall;
    Relation<Dim>* list;
    std::optional<MadeMethod<Dim>> force;
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a free-slip wall exerts no viscous force", "", ((int Dim), Dim), 2, 3) {
    for (const char* form : {"laplacian", "central"}) {
        const auto gliding = [](double) { return 1.0; };
        const Stream<Dim> free("free_slip", form, gliding);
        const auto& a = free.acceleration();
        for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].norm() == 0);
        CHECK(free.forceOnWall().norm() == 0);

        // Where the wall holds the water it does.
        const Stream<Dim> held("no_slip", form, gliding);
        CHECK(held.accelerationAt(0)[0] < -1);
        CHECK(held.forceOnWall()[0] > 0.1);
    }
}

TEMPLATE_TEST_CASE_SIG(
    "along a no-slip wall uniform shear is at rest in itself, and pulls the wall", "",
    ((int Dim), Dim), 2, 3) {
    const Stream<Dim> stream("no_slip", "laplacian", [](double y) { return shear * y; });
    const double scale = viscosity / density * shear / spacing;
    for (double y = 0.5 * spacing; y < length - 4 * spacing; y += spacing)
        CHECK(stream.accelerationAt(y).norm() < list_error * scale);
    if constexpr (Dim == 2) {
        CHECK(stream.forceOnWall()[0] == Approx(viscosity * shear * length).epsilon(list_error));
        CHECK(std::abs(stream.forceOnWall()[1]) < list_error);
    }
}
