// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../scene/scene.h"
#include "../scene/values.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::dynamics;
using namespace sphinx::test;

namespace {

constexpr double rho0 = test::density;
/// Sums are exact on a grid as fine as this (core/exact_sum.h).
constexpr double rounding = 1e-11;
/// Of a step, and what it leaves of a difference from the sum.
constexpr double dt = 0.1;
const double left = std::exp(-dt * sound_speed / (250 * spacing));

/// A block of water, 12 spacings wide and high, on y = 0.
template <int Dim>
struct Block : Scene<Dim> {
    Body<Dim>& water = this->fluid("water", this->lattice(12));
    Field<double>& rho = water.particles.scalar(fields::density);

    /// The particle nearest to a place, in spacings.
    std::size_t at(double x, double y) const {
        Vec<Dim> place = Vec<Dim>::Constant(6);
        place.template head<2>() = Vec<2>(x, y);
        return nearest<Dim>(water, spacing * place);
    }
    /// A floor below it, of that spacing.
    void addWall(double its_spacing) {
        this->spacing = its_spacing;
        Vec<Dim> lower = Vec<Dim>::Zero();
        Vec<Dim> upper = Vec<Dim>::Constant(12 * test::spacing);
        lower[1] = -4 * test::spacing;
        upper[1] = 0;
        water.sees.push_back(&this->wall("floor", this->box(lower, upper), Face{}));
    }
    void sumDensities(const std::string& surface, const Clock& clock = {.dt = dt}) {
        const auto summation =
            this->method("type: fluid.density_summation, body: water, surface: " + surface);
        this->relations.update({&water});
        summation.run(clock);
    }
};

/// The sum of (54) over all particles, of that of the full lattice, by a search.
template <int Dim>
double share(const Body<Dim>& water, std::size_t i) {
    double sum = 0;
    for (const Body<Dim>* other : water.sees)
        for (std::size_t j = 0; j < other->size(); ++j)
            sum += std::pow(other->spacing / water.spacing, Dim) *
                   water.kernel.value(
                       (water.particles.position()[i] - other->particles.position()[j]).norm());
    return sum / water.kernel.latticeSum();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("density by summation over a lattice", "", ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    auto& rho = block.rho;
    const std::size_t inside = block.at(6, 6);
    const std::size_t surface = block.at(6, 12);
    const std::size_t corner = block.at(12, 12);

    const std::size_t second_row = block.at(6, 11);
    auto& slack = block.water.particles.scalar(fields::slack);

    SECTION("with a free surface: inside a part of the difference, either way") {
        for (const double start : {0.9, 1.1}) {
            rho[inside] = start * rho0;
            block.sumDensities("free");
            CHECK(rho[inside] / rho0 == Approx(1 + left * (start - 1)).epsilon(rounding));
        }
        CHECK(slack[inside] == 0);
    }
    SECTION("two halves of a step do as much as the step, no time does nothing") {
        rho[inside] = 0.9 * rho0;
        for (const double step : {0.4 * dt, 0.6 * dt}) block.sumDensities("free", {.dt = step});
        CHECK(rho[inside] / rho0 == Approx(1 - 0.1 * left).epsilon(rounding));
        const double before = rho[inside];
        block.sumDensities("free", {.dt = dt, .is_start = true});
        CHECK(rho[inside] == before);
    }
    SECTION("at the surface nothing is taken away, and what bears no tension has its own density") {
        block.sumDensities("free");
        for (const std::size_t i : {surface, corner, second_row}) CHECK(rho[i] == rho0);
        for (const std::size_t i : {surface, corner}) CHECK(slack[i] == 1);
        CHECK(slack[second_row] == 0);
        for (const std::size_t i : {surface, corner, second_row}) rho[i] = 1.1 * rho0;
        block.sumDensities("free");
        for (const std::size_t i : {surface, corner, second_row}) CHECK(rho[i] == 1.1 * rho0);
        for (const std::size_t i : {surface, corner, second_row}) rho[i] = 0.1 * rho0;
        block.sumDensities("free");
        CHECK(rho[surface] == rho0);
        CHECK(rho[corner] == rho0);
        CHECK(rho[second_row] == Approx(share(block.water, second_row) * rho0).epsilon(rounding));
    }
    SECTION("what begins to bear tension has no void left") {
        slack[second_row] = 1;
        rho[second_row] = 0.99 * rho0;
        block.sumDensities("free");
        CHECK(slack[second_row] == 0);
        CHECK(rho[second_row] == rho0);
    }
    SECTION("confined: (55) is the sum itself, of the density at the start") {
        auto& reference = block.water.particles.scalar(fields::reference_density);
        for (std::size_t i = 0; i < reference.size(); ++i) {
            reference[i] = 1.05 * rho0;
            rho[i] = 1.3 * rho0;
        }
        block.sumDensities("confined");
        CHECK(rho[inside] == Approx(1.05 * rho0).epsilon(rounding));
        for (const std::size_t i : {surface, corner})
            CHECK(rho[i] == Approx(share(block.water, i) * 1.05 * rho0).epsilon(rounding));
        // Half a spacing from the surface is 0.8 of the neighborhood, at the edge of two 0.8^2.
        CHECK(rho[surface] == Approx(0.8 * 1.05 * rho0).epsilon(0.03));
        CHECK(rho[corner] == Approx(0.64 * 1.05 * rho0).epsilon(0.05));
    }
}

TEMPLATE_TEST_CASE_SIG("density by summation rises as volumes shrink", "", ((int Dim), Dim), 2, 3) {
    constexpr double squeezed = 0.98;
    Block<Dim> block;
    give(block.water, fields::position,
         [&](const Vec<Dim>& x) -> Vec<Dim> { return squeezed * x; });
    const std::size_t inside = block.at(6, 6);
    const double sum = share(block.water, inside);
    CHECK(sum == Approx(1 / std::pow(squeezed, Dim)).epsilon(0.005));
    block.sumDensities("free");
    CHECK(block.rho[inside] / rho0 == Approx(1 + (1 - left) * (sum - 1)).epsilon(rounding));
}

TEMPLATE_TEST_CASE_SIG("density by summation at a wall", "", ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    give(block.water, fields::reference_density, [](const Vec<Dim>&) { return rho0; });
    const std::size_t bottom = block.at(6, 0);

    SECTION("that continues the lattice is as inside") {
        block.addWall(spacing);
        block.sumDensities("confined");
        CHECK(block.rho[bottom] == Approx(rho0).epsilon(rounding));
    }
    SECTION("leaves the fluid no tension, and a gap is remembered") {
        block.addWall(spacing);
        block.rho[bottom] = 0.999 * rho0;
        block.sumDensities("free");
        CHECK(block.water.particles.scalar(fields::slack)[bottom] == 1);
        CHECK(block.rho[bottom] / rho0 == Approx(1 - left * 0.001).epsilon(rounding));
    }
    SECTION("of half the spacing counts by its volumes") {
        block.addWall(spacing / 2);
        block.sumDensities("confined");
        CHECK(block.rho[bottom] == Approx(share(block.water, bottom) * rho0).epsilon(rounding));
        CHECK(block.rho[bottom] == Approx(rho0).epsilon(0.02));
    }
}

TEMPLATE_TEST_CASE_SIG("a particle without neighbors has no pressure", "", ((int Dim), Dim), 2, 3) {
    Block<Dim> block;
    const std::size_t corner = block.at(12, 12);
    block.water.particles.position()[corner] += Vec<Dim>::Constant(10 * spacing);
    for (const double start : {0.9, 1.1}) {
        block.rho[corner] = start * rho0;
        block.sumDensities("free");
        CHECK(block.rho[corner] == rho0);
    }
}
