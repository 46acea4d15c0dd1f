// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/pair_tiles.h"

#include "core/errors.h"

#include <catch2/catch.hpp>

#include <limits>
#include <map>
#include <random>

using namespace sphinx;
using namespace sphinx::neighbors;

namespace {

constexpr double spacing = 0.1;

template <int Dim>
std::vector<Vec<Dim>> randomPoints(std::size_t n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec<Dim>> points(n);
    for (Vec<Dim>& point : points)
        for (int k = 0; k < Dim; ++k) point[k] = unit(random);
    return points;
}

/// Every pair once, in a periodic domain those across its sides from both sides; weights and sums
/// of W those of the kernel.
template <class Real = float, int Dim>
void compareWithAllPairs(const std::vector<Vec<Dim>>& points, kernels::KernelType type,
                         bool periodic) {
    const kernels::Kernel<Dim> kernel(type, 1.1 * spacing, spacing);
    bodies::Domain<Dim> domain;
    domain.bounds.lower = Vec<Dim>::Zero();
    domain.bounds.upper = Vec<Dim>::Ones();
    for (bool& axis : domain.periodic) axis = periodic;
    PairTiles<Dim> tiles(std::is_same_v<Real, float> ? Precision::single : Precision::full);
    tiles.build(points.data(), points.size(), kernel, spacing, domain);

    const double steep = -kernel.derivative(spacing);
    std::map<std::pair<Index, Index>, int> seen;  // from i
    std::size_t wrong = 0;
    for (const auto& chunk : tiles.chunks()) {
        const Real* weights = chunk.template weights<Real>().data();
        for (std::size_t c = 0; c + 1 < chunk.ranges.size(); ++c) {
            const std::uint32_t end = chunk.ranges[c + 1].one_sided;
            for (std::uint32_t t = chunk.ranges[c].one_sided; t < end; ++t) {
                const bool both = t >= chunk.ranges[c].two_sided;
                for (Index k = 0; k < tile_size; ++k) {
                    const Real weight = weights[tile_size * t + k];
                    if (weight == 0) continue;
                    const Index si = chunk.first_slot + static_cast<Index>(4 * c) + k / tile_side;
                    const Index sj = chunk.j[tile_side * t + k % tile_side];
                    const Index i = tiles.particle(si);
                    const Index j = tiles.particle(sj);
                    REQUIRE(i != tiles.none);
                    REQUIRE(j != tiles.none);
                    ++seen[{i, j}];
                    if (both) ++seen[{j, i}];
                    Vec<Dim> d;
                    for (int a = 0; a < Dim; ++a) {
                        const auto whole = static_cast<std::int32_t>(
                            static_cast<std::uint32_t>(tiles.place(si).whole[a]) -
                            static_cast<std::uint32_t>(tiles.place(sj).whole[a]));
                        d[a] = whole;
                        if (std::is_same_v<Real, double>)
                            d[a] += double{tiles.place(si).rest[a]} - tiles.place(sj).rest[a];
                        d[a] *= tiles.placeUnit();
                    }
                    const Vec<Dim> exact = domain.difference(points[i], points[j]);
                    const double gradient =
                        weight * d.norm() / tiles.placeUnit() * tiles.gradientUnit();
                    const double expected =
                        -kernel.gradientFactor() * kernel.derivative(exact.norm());
                    const double place_error = std::is_same_v<Real, float> ? 3e-8 : 1e-14;
                    const double error = std::is_same_v<Real, float> ? 1e-6 : 1e-8;
                    wrong += (d - exact).norm() > place_error * spacing ||
                             std::abs(gradient - expected) > error * expected + 0.1 * error * steep;
                }
            }
        }
    }
    CHECK(wrong == 0);
    std::size_t pairs = 0;
    for (Index i = 0; i < points.size(); ++i) {
        double sum = 0;
        for (Index j = 0; j < points.size(); ++j) {
            const double r = domain.difference(points[i], points[j]).norm();
            if (i == j || r >= kernel.cutoff() * (1 - 1e-7)) continue;
            sum += kernel.value(r);
            ++pairs;
            REQUIRE(seen[{i, j}] == 1);
        }
        CHECK(tiles.particles()[tiles.slotsOf()[i]] == i);
        CHECK(tiles.kernelSums()[i] == Approx(sum).margin(1e-8 * kernel.value(0)));
    }
    CHECK(seen.size() <= pairs + 2);
    CHECK(pairs > 0);
}

template <class Real, int Dim>
void compareWithAllPairs(std::size_t n) {
    for (const auto type : {kernels::KernelType::wendland_c2, kernels::KernelType::cubic_spline,
                            kernels::KernelType::quintic_spline})
        for (const bool periodic : {false, true})
            compareWithAllPairs<Real>(randomPoints<Dim>(n, 7), type, periodic);
}

}  // namespace

TEMPLATE_TEST_CASE("tiles have every pair once", "", float, double) {
    compareWithAllPairs<TestType, 2>(400);
    compareWithAllPairs<TestType, 3>(800);
}

TEST_CASE("tiles of few particles, and of particles far from each other") {
    compareWithAllPairs<float, 2>({{0.1, 0.1}, {0.15, 0.1}}, kernels::KernelType::wendland_c2,
                                  false);
    // Two crowds with next to nothing in between, in few and wide columns.
    std::vector<Vec<3>> points = randomPoints<3>(200, 3);
    for (std::size_t i = 0; i < 100; ++i) points[i][1] += 4000;
    points.emplace_back(-3e5, 2e4, 0.5);
    compareWithAllPairs<float, 3>(points, kernels::KernelType::wendland_c2, false);

    PairTiles<2> tiles;
    const kernels::Kernel<2> kernel(kernels::KernelType::wendland_c2, 1, 1);
    tiles.build(nullptr, 0, kernel, 1, {});
    CHECK(tiles.slots() == 0);
    Vec<2> nowhere(0, std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_AS(tiles.build(&nowhere, 1, kernel, 1, {}), PhysicsError);
}
