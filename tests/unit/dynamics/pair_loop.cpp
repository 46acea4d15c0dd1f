// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/pair_loop.h"

#include "neighbors/list_builder.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::dynamics;

TEMPLATE_TEST_CASE_SIG("pairs have the gradient of their kernel in any unit of length", "",
                       ((int Dim), Dim), 2, 3) {
    // From nanometres to light years.
    for (const double spacing : {1e-9, 1e-3, 1.0, 1e16}) {
        const double h = 1.3 * spacing;
        const Kernel<Dim> kernel(kernels::KernelType::wendland_c2, h, spacing);
        const double r = 0.8 * spacing;
        std::vector<Vec<Dim>> points{Vec<Dim>::Zero(), Vec<Dim>::Zero()};
        points[1][0] = 0.6 * r;
        points[1][1] = -0.8 * r;
        neighbors::CellGrid<Dim> grid;
        grid.build(points.data(), points.size(), kernel.cutoff());
        NeighborList<Dim> list;
        neighbors::buildList(grid, grid, true, kernel, Domain<Dim>{}, list);
        const double dW = -kernel.gradientFactor() * kernel.derivative(r);
        const double unit = list.gradient_unit;
        int blocks = 0;
        forEachPair(list, 0, [&](const Pairs<Dim>& pair) {
            CHECK(pair.index[0] == 1);
            CHECK(unit * pair.gradient[0][0] == Approx(0.6 * dW).epsilon(1e-8));
            CHECK(unit * pair.gradient[1][0] == Approx(-0.8 * dW).epsilon(1e-8));
            CHECK(unit * pair.dW[0] == Approx(dW).epsilon(1e-8));
            CHECK(pair.inverse_dW[0] / unit == Approx(1 / dW).epsilon(1e-8));
            CHECK(pair.gradient[0][1] == 0);
            CHECK(std::isfinite(pair.inverse_dW[1]));
            ++blocks;
        });
        CHECK(blocks == 1);
    }
}
