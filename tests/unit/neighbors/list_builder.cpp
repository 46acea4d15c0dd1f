// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "neighbors/list_builder.h"

#include "core/errors.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <set>
#include <thread>

using namespace sphinx;
using namespace sphinx::neighbors;

namespace {

constexpr double h = 0.13;

/// Points spread at random over the unit square or cube, moved by an offset along x.
template <int Dim>
std::vector<Vec<Dim>> randomPoints(std::size_t n, unsigned seed, double offset = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec<Dim>> points(n);
    for (Vec<Dim>& point : points) {
        for (int k = 0; k < Dim; ++k) point[k] = unit(random);
        point[0] += offset;
    }
    return points;
}

template <int Dim>
CellGrid<Dim> gridOf(const std::vector<Vec<Dim>>& points, const kernels::Kernel<Dim>& kernel) {
    CellGrid<Dim> grid;
    grid.build(points.data(), points.size(), kernel.cutoff());
    return grid;
}

template <int Dim>
bodies::Domain<Dim> unitDomain(bool periodic) {
    bodies::Domain<Dim> domain;
    domain.bounds.lower = Vec<Dim>::Zero();
    domain.bounds.upper = Vec<Dim>::Ones();
    domain.periodic[0] = periodic;
    return domain;
}

/// Builds the lists and compares them with a search over all pairs.
template <int Dim>
void compareWithAllPairs(bool same, bool periodic) {
    const kernels::Kernel<Dim> kernel(kernels::KernelType::wendland_c2, h, h / 1.3);
    const bodies::Domain<Dim> domain = unitDomain<Dim>(periodic);
    const auto from = randomPoints<Dim>(700, 1);
    const auto to = same ? from : randomPoints<Dim>(500, 2);
    NeighborList<Dim> list;
    buildList(gridOf(from, kernel), gridOf(to, kernel), same, kernel, domain, list);

    REQUIRE(list.ranges.size() == from.size());
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::set<std::uint32_t> expected;
        for (std::size_t j = 0; j < to.size(); ++j)
            if (!(same && i == j) && domain.difference(from[i], to[j]).norm() < kernel.cutoff())
                expected.insert(static_cast<std::uint32_t>(j));
        std::set<std::uint32_t> found;
        std::size_t k = 0;
        for (const auto& block : list.of(i)) {
            for (int lane = 0; lane < lane_count; ++lane, ++k) {
                Vec<Dim> gradient;
                for (int c = 0; c < Dim; ++c)
                    gradient[c] = list.gradient_unit * block.gradient[c][lane];
                if (k >= list.ranges[i].count) {
                    REQUIRE(gradient.norm() == 0);
                    continue;
                }
                found.insert(block.index[lane]);
                const Vec<Dim> d = domain.difference(from[i], to[block.index[lane]]);
                const Vec<Dim> exact =
                    d * (kernel.gradientFactor() * kernel.derivative(d.norm()) / d.norm());
                REQUIRE((gradient - exact).norm() <= 1e-6 * exact.norm() + 1e-4);
            }
        }
        REQUIRE(found == expected);
        REQUIRE(list.ranges[i].count == expected.size());
        pairs += expected.size();
    }
    CHECK(pairs > 3 * from.size());
}

}  // namespace

TEST_CASE("lists hold the pairs that a search over all pairs finds") {
    for (const bool same : {true, false})
        for (const bool periodic : {true, false}) {
            CAPTURE(same, periodic);
            compareWithAllPairs<2>(same, periodic);
            compareWithAllPairs<3>(same, periodic);
        }
}

TEST_CASE("a thread whose first cells have nothing near them builds empty lists") {
    const kernels::Kernel<2> kernel(kernels::KernelType::wendland_c2, h, h / 1.3);
    const auto from = randomPoints<2>(100, 1);
    const auto far = randomPoints<2>(100, 2, 10);
    NeighborList<2> list;
    // A thread of its own: buffers of earlier lists must not help.
    std::thread([&] {
        buildList(gridOf(from, kernel), gridOf(far, kernel), false, kernel, unitDomain<2>(false),
                  list);
    }).join();
    REQUIRE(list.ranges.size() == from.size());
    for (const auto& range : list.ranges) REQUIRE(range.count == 0);
}

TEST_CASE("positions that are not finite make no cells") {
    std::vector<Vec<2>> position(100, Vec<2>(0.5, 0.25));
    CellGrid<2> grid;
    grid.build(position.data(), position.size(), 0.1);
    CHECK(grid.cells() == 1);
    position[37][1] =
        GENERATE(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_AS(grid.build(position.data(), position.size(), 0.1), PhysicsError);
}
