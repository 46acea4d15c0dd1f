// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/density_summation.h"
#include "fluid.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::fluid;
using sphinx::test::filled;
using sphinx::test::FluidScene;

namespace {

constexpr double rho0 = FluidScene<2>::density;
/// Sums are exact on a grid as fine as this (core/exact_sum.h).
constexpr double rounding = 1e-11;

/// A block of water, 12 spacings wide and high, on y = 0.
template <int Dim>
std::vector<Vec<Dim>> blockOfWater(double spacing = FluidScene<Dim>::spacing) {
    return filled<Dim>(Vec<Dim>::Zero(), Vec<Dim>::Constant(12 * spacing), spacing);
}

/// The sum of (54) over all particles, of that of the full lattice, by a search.
template <int Dim>
double share(FluidScene<Dim>& scene, std::size_t i) {
    const Body<Dim>& water = *scene.water;
    double sum = 0;
    for (const Body<Dim>* other : water.sees)
        for (std::size_t j = 0; j < other->size(); ++j)
            sum += std::pow(other->spacing / water.spacing, Dim) *
                   water.kernel.value(
                       (water.particles.position()[i] - other->particles.position()[j]).norm());
    return sum / water.kernel.latticeSum();
}

template <int Dim>
void sumDensities(FluidScene<Dim>& scene, Surface surface) {
    DensitySummation<Dim> summation(scene.context, *scene.water, surface);
    scene.relations.update({scene.water});
    summation.run({});
}

/// The particle nearest to a place, in spacings.
template <int Dim>
std::size_t at(FluidScene<Dim>& scene, double x, double y) {
    Vec<Dim> place = Vec<Dim>::Constant(6);
    place.template head<2>() = Vec<2>(x, y);
    const auto& r = scene.water->particles.position();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < r.size(); ++i)
        if ((r[i] - scene.spacing * place).norm() < (r[nearest] - scene.spacing * place).norm())
            nearest = i;
    return nearest;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("density by summation over a lattice", "", ((int Dim), Dim), 2, 3) {
    FluidScene<Dim> scene(blockOfWater<Dim>());
    auto& rho = scene.water->particles.scalar(fields::density);
    const std::size_t inside = at(scene, 6, 6);
    const std::size_t surface = at(scene, 6, 12);
    const std::size_t corner = at(scene, 12, 12);

    SECTION("with a free surface: (54) adds what is missing, and takes nothing away") {
        rho[inside] = 0.9 * rho0;
        sumDensities(scene, Surface::free);
        CHECK(rho[inside] == Approx(rho0).epsilon(rounding));
        CHECK(rho[surface] == rho0);
        CHECK(rho[corner] == rho0);
        rho[surface] = 1.1 * rho0;
        rho[corner] = 0.1 * rho0;
        sumDensities(scene, Surface::free);
        CHECK(rho[surface] == 1.1 * rho0);
        CHECK(rho[corner] == Approx(share(scene, corner) * rho0).epsilon(rounding));
    }
    SECTION("confined: (55) is the sum itself, of the density at the start") {
        auto& reference = scene.water->particles.scalar(fields::reference_density);
        for (std::size_t i = 0; i < reference.size(); ++i) {
            reference[i] = 1.05 * rho0;
            rho[i] = 1.3 * rho0;
        }
        sumDensities(scene, Surface::confined);
        CHECK(rho[inside] == Approx(1.05 * rho0).epsilon(rounding));
        for (const std::size_t i : {surface, corner})
            CHECK(rho[i] == Approx(share(scene, i) * 1.05 * rho0).epsilon(rounding));
        // Half a spacing from the surface is 0.8 of the neighborhood, at the edge of two 0.8^2.
        CHECK(rho[surface] == Approx(0.8 * 1.05 * rho0).epsilon(0.03));
        CHECK(rho[corner] == Approx(0.64 * 1.05 * rho0).epsilon(0.05));
    }
}

TEMPLATE_TEST_CASE_SIG("density by summation rises as volumes shrink", "", ((int Dim), Dim), 2, 3) {
    constexpr double squeezed = 0.98;
    FluidScene<Dim> scene(blockOfWater<Dim>(squeezed * FluidScene<Dim>::spacing));
    sumDensities(scene, Surface::free);
    const std::size_t inside = at(scene, 6, 6);
    const double rho = scene.water->particles.scalar(fields::density)[inside];
    CHECK(rho == Approx(share(scene, inside) * rho0).epsilon(rounding));
    CHECK(rho == Approx(rho0 / std::pow(squeezed, Dim)).epsilon(0.005));
}

TEMPLATE_TEST_CASE_SIG("density by summation at a wall", "", ((int Dim), Dim), 2, 3) {
    FluidScene<Dim> scene(blockOfWater<Dim>());
    Vec<Dim> lower = Vec<Dim>::Zero();
    Vec<Dim> upper = Vec<Dim>::Constant(12 * scene.spacing);
    lower[1] = -4 * scene.spacing;
    upper[1] = 0;
    auto& reference = scene.water->particles.scalar(fields::reference_density);
    for (std::size_t i = 0; i < reference.size(); ++i) reference[i] = rho0;
    const std::size_t bottom = at(scene, 6, 0);
    const auto& rho = scene.water->particles.scalar(fields::density);

    SECTION("that continues the lattice is as inside") {
        scene.addWall(filled<Dim>(lower, upper, scene.spacing), scene.spacing);
        sumDensities(scene, Surface::confined);
        CHECK(rho[bottom] == Approx(rho0).epsilon(rounding));
    }
    SECTION("of half the spacing counts by its volumes") {
        scene.addWall(filled<Dim>(lower, upper, scene.spacing / 2), scene.spacing / 2);
        sumDensities(scene, Surface::confined);
        CHECK(rho[bottom] == Approx(share(scene, bottom) * rho0).epsilon(rounding));
        CHECK(rho[bottom] == Approx(rho0).epsilon(0.02));
    }
}
