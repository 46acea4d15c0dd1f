// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"
#include "../scene/values.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double viscosity = 0.3;
constexpr int side = 6;

/// A cube of water, in walls or where space repeats.
template <int Dim>
struct Cube : Scene<Dim> {
    Cube(kernels::KernelType kernel, double ratio, const std::string& form, bool walls,
         std::optional<kernels::Kernel<Dim>> wall_kernel = {}) {
        const double size = side * spacing;
        water = &this->fluid("water", this->lattice(side), {.viscosity = viscosity});
        water->kernel = kernels::Kernel<Dim>(kernel, ratio * spacing, spacing);
        if (walls)
            addWalls(size, wall_kernel);
        else
            for (int k = 0; k < Dim; ++k)
                this->repeat(k, Vec<Dim>::Zero(), Vec<Dim>::Constant(size));
        force.emplace(this->method("type: fluid.viscous_force, body: water, form: " + form));
        (*force)->announce();
        this->relations.update({water});
        give(*water, fields::velocity,
             [&](const Vec<Dim>&) -> Vec<Dim> { return this->random.template vector<Dim>(1); });
    }
    void addWalls(double size, const std::optional<kernels::Kernel<Dim>>& wall_kernel) {
        const double reach = wall_kernel ? wall_kernel->cutoff() : water->kernel.cutoff();
        const double width = std::ceil(reach / spacing) * spacing;
        std::vector<Vec<Dim>> points;
        for (const Vec<Dim>& x :
             this->box(Vec<Dim>::Constant(-width), Vec<Dim>::Constant(size + width)))
            if (x.minCoeff() < 0 || x.maxCoeff() > size) points.push_back(x);
        Body<Dim>& wall = this->wall("wall", points);
        wall.kernel = wall_kernel ? *wall_kernel : water->kernel;
        auto& normal = wall.particles.vector(fields::normal);
        auto& depth = wall.particles.scalar(fields::depth);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec<Dim> out = points[i] - points[i].cwiseMax(0).cwiseMin(size);
            depth[i] = out.norm();
            normal[i] = -out / depth[i];
        }
        water->sees = {water, &wall};
    }
    /// The largest rate at which the force changes velocities: by the power method.
    double largestRate() {
        auto& v = water->particles.vector(fields::velocity);
        auto& a = water->particles.vector(fields::external_acceleration);
        double rate = 0;
        for (int step = 0; step < 400; ++step) {
            a.setZero();
            force->run({});
            double aa = 0, vv = 0;
            for (std::size_t i = 0; i < water->size(); ++i) {
                aa += a[i].squaredNorm();
                vv += v[i].squaredNorm();
            }
            rate = std::sqrt(aa / vv);
            for (std::size_t i = 0; i < water->size(); ++i) v[i] = a[i] / std::sqrt(aa);
        }
        return rate;
    }

    Body<Dim>* water;
    std::optional<MadeMethod<Dim>> force;
};

template <int Dim>
void checkBound(kernels::KernelType kernel, double ratio, const std::string& form) {
    for (const bool walls : {false, true}) {
        Cube<Dim> cube(kernel, ratio, form, walls);
        const double bound = cube.water->fluid().viscous.rate(density);
        const double rate = cube.largestRate();
        INFO(kernels::kernelName(kernel)
             << ' ' << ratio << ' ' << form << (walls ? ", walls" : "") << ": " << bound / rate);
        CHECK(bound > rate);
        CHECK(bound < 1.3 * rate);
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("the viscous force of a lattice is bounded, in corners of walls as well", "",
                       ((int Dim), Dim), 2, 3) {
    using enum kernels::KernelType;
    for (const char* form : {"laplacian", "central"}) {
        for (const double ratio : {0.8, 1.0, 1.3}) {
            checkBound<Dim>(quintic_spline, ratio, form);
            checkBound<Dim>(cubic_spline, ratio, form);
        }
        for (const double ratio : {0.8, 1.1, 1.3, 1.5, 2.0})
            checkBound<Dim>(wendland_c2, ratio, form);
    }
}

TEST_CASE("walls of a larger kernel have the sums of theirs") {
    using enum kernels::KernelType;
    Cube<2> cube(wendland_c2, 0.8, "laplacian", true,
                 kernels::Kernel<2>(quintic_spline, 1.3 * spacing, spacing));
    CHECK(cube.water->fluid().viscous.rate(density) > cube.largestRate());
}

TEST_CASE("the default step of a laplacian along walls is that of guide (52), in 2D") {
    Cube<2> cube(kernels::KernelType::quintic_spline, 1, "laplacian", true);
    const double nu = viscosity / density;
    CHECK(2 / cube.water->fluid().viscous.rate(density) > 0.325 * spacing * spacing / nu);
}

TEMPLATE_TEST_CASE_SIG("the advection step is no larger than the force allows", "",
                       ((int Dim), Dim), 2, 3) {
    Cube<Dim> cube(kernels::KernelType::wendland_c2, 1.3, "laplacian", true);
    const double rate = cube.water->fluid().viscous.rate(density);
    const auto step = [&](const std::string& cfl) {
        return cube
            .timeStep("type: fluid.advection_time_step, body: water, reference_speed: 1e-3" + cfl)
            ->estimate();
    };
    cube.water->particles.vector(fields::velocity).setZero();
    CHECK(step("") == 2 / rate);
    CHECK(step(", cfl: 1") == 2 / rate);
    const double h = 1.3 * spacing;
    CHECK(step(", cfl: 0.1") == Approx(0.1 * h * h * density / viscosity));
}

TEST_CASE("a light elastic body that viscous forces push bounds the step") {
    Scene<2> scene;
    const double top = 6 * spacing;
    Body<2>& water = scene.fluid("water", scene.box({0, 0}, {top, top}), {.viscosity = viscosity});
    Body<2>& plate =
        scene.elastic("plate", scene.box({0, -3 * spacing}, {top, 0}), {.density = 0.1});
    water.sees = {&water, &plate};
    plate.sees = {&plate, &water};
    const auto force = scene.method("type: fluid.viscous_force, body: water");
    const auto drag = scene.method("type: fsi.viscous_force, body: plate, from: water");
    force->announce();
    const double alone = water.fluid().viscous.rate(density);
    drag->announce();
    // By half of the weights or more, 20 times.
    CHECK(water.fluid().viscous.rate(density) > 5 * alone);
    CHECK(water.fluid().viscous.rate(density) < 20 * alone);
    const auto step =
        scene.timeStep("type: fluid.advection_time_step, body: water, reference_speed: 1e-3");
    CHECK(step->estimate() == 2 / water.fluid().viscous.rate(density));
}
