// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "fitting/relax.h"

#include "core/parallel.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace sphinx;
using fitting::Relaxed;
using geometry::Shape;
using geometry::ShapePointer;
using kernels::KernelType;

namespace {

template <int Dim>
Relaxed<Dim> relaxed(const Shape<Dim>& shape, double spacing,
                     KernelType type = KernelType::wendland_c2,
                     const fitting::RelaxLimits& limits = {}) {
    const double ratio = type == KernelType::quintic_spline ? 1 : 1.3;
    return fitting::relax<Dim>(shape, {spacing, Vec<Dim>::Zero()},
                               kernels::Kernel<Dim>(type, ratio * spacing, spacing), limits);
}

ShapePointer<2> star(double tip, double notch, const Vec<2>& middle = Vec<2>::Zero()) {
    std::vector<Vec<2>> corners;
    for (int k = 0; k < 10; ++k) {
        const double angle = std::numbers::pi * (0.5 + 0.2 * k);
        corners.emplace_back(middle +
                             (k % 2 ? notch : tip) * Vec<2>(std::cos(angle), std::sin(angle)));
    }
    return geometry::makePolygon(corners);
}

template <int Dim>
double nearest(const std::vector<Vec<Dim>>& points, const Vec<Dim>& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec<Dim>& y : points)
        if (y != x) least = std::min(least, (y - x).norm());
    return least;
}

template <int Dim>
void checkFitted(const Shape<Dim>& shape, double spacing, KernelType type) {
    const Relaxed<Dim> found = relaxed(shape, spacing, type);
    CHECK(found.converged);
    CHECK(found.residual <= 5e-3);
    CHECK(!found.thin);
    const auto n = static_cast<double>(found.points.size());
    CHECK(n * found.volume == Approx(shape.measure()).epsilon(1e-12));
    CHECK(found.volume == Approx(std::pow(spacing, Dim)).epsilon(0.006));

    double squares = 0;
    std::size_t row = 0;
    double closest = spacing;
    const kernels::Kernel<Dim> kernel(
        type, type == KernelType::quintic_spline ? spacing : 1.3 * spacing, spacing);
    double density_squares = 0;
    std::size_t inner = 0;
    for (const Vec<Dim>& x : found.points) {
        const double depth = -shape.signedDistance(x);
        closest = std::min(closest, nearest(found.points, x));
        if (depth < spacing) {
            ++row;
            squares += std::pow(depth / spacing - 0.5, 2);
        }
        if (depth < kernel.cutoff()) continue;
        double sum = 0;
        for (const Vec<Dim>& y : found.points) sum += found.volume * kernel.value((y - x).norm());
        density_squares += std::pow(sum / (std::pow(spacing, Dim) * kernel.latticeSum()) - 1, 2);
        ++inner;
    }
    CHECK(row == found.row);
    CHECK(std::sqrt(squares / static_cast<double>(row)) < 0.01);
    // The kernel's sum over particles in disorder is larger than over a lattice of the same
    // density.
    REQUIRE(inner > 0);
    CHECK(std::sqrt(density_squares / static_cast<double>(inner)) < 0.02);
    CHECK(closest > 0.55 * spacing);
}

template <int Dim>
void sortPlaces(std::vector<Vec<Dim>>& points) {
    std::ranges::sort(points, [](const Vec<Dim>& a, const Vec<Dim>& b) {
        return std::lexicographical_compare(a.data(), a.data() + Dim, b.data(), b.data() + Dim);
    });
}

}  // namespace

TEST_CASE("relaxed particles stand in a row half a spacing inside of a surface, spread evenly") {
    const auto type = GENERATE(KernelType::wendland_c2, KernelType::quintic_spline);
    SECTION("circle") { checkFitted<2>(*geometry::makeBall<2>({0, 0}, 1), 0.05, type); }
    SECTION("star with sharp tips") { checkFitted<2>(*star(1, 0.382), 0.04, type); }
    SECTION("rectangle that is no whole number of spacings") {
        checkFitted<2>(*geometry::makeBox<2>({0.013, 0.007}, {1, 0.73}), 0.05, type);
    }
    SECTION("sphere") { checkFitted<3>(*geometry::makeBall<3>({0, 0, 0}, 1), 0.11, type); }
    SECTION("torus") {
        checkFitted<3>(*geometry::makeTorus({0, 0, 0}, {0, 0, 1}, 1, 0.5), 0.1, type);
    }
}

TEST_CASE("the row has as many particles as its layer has volume, on each of two surfaces") {
    const double spacing = 0.05;
    const auto ring = geometry::makeDifference<2>(
        {geometry::makeBall<2>({0, 0}, 1), geometry::makeBall<2>({0, 0}, 0.5)});
    const Relaxed<2> found = relaxed(*ring, spacing);
    int inner = 0, outer = 0;
    for (const Vec<2>& x : found.points) {
        inner += x.norm() < 0.5 + spacing;
        outer += x.norm() > 1 - spacing;
    }
    const double per_length = spacing / found.volume;  // of the middle of a layer
    CHECK(inner == Approx(2 * std::numbers::pi * 0.525 * per_length).margin(1));
    CHECK(outer == Approx(2 * std::numbers::pi * 0.975 * per_length).margin(1));
}

TEST_CASE("a lattice that fits its shape is at rest") {
    const double spacing = 0.125;
    const Relaxed<2> plane = relaxed(*geometry::makeBox<2>({0, 0}, {2, 1}), spacing);
    REQUIRE(plane.points.size() == 128);
    for (const Vec<2>& x : plane.points)
        for (int k = 0; k < 2; ++k) CHECK(std::fmod(x[k], spacing) == 0.5 * spacing);
    CHECK(plane.residual < 1e-9);
    const Relaxed<3> space = relaxed(*geometry::makeBox<3>({0, 0, 0}, {1, 1, 1}), spacing);
    REQUIRE(space.points.size() == 512);
    for (const Vec<3>& x : space.points)
        for (int k = 0; k < 3; ++k) CHECK(std::fmod(x[k], spacing) == 0.5 * spacing);
}

TEST_CASE("relaxed particles have the same bits on any number of threads") {
    const auto shape = geometry::makeBall<3>({0.01, 0.02, 0.03}, 1);
    setThreadCount(1);
    const Relaxed<3> one = relaxed(*shape, 0.12);
    setThreadCount(3);
    const Relaxed<3> three = relaxed(*shape, 0.12);
    setThreadCount(1);
    CHECK(one.steps == three.steps);
    CHECK(one.residual == three.residual);
    CHECK(one.points == three.points);
}

TEST_CASE("a mirrored shape has mirrored particles") {
    const ShapePointer<2> shape =
        geometry::makePolygon({{0.1, 0}, {1.3, 0.2}, {0.9, 1.1}, {0.4, 0.6}});
    const ShapePointer<2> image = geometry::makeMirrored<2>(shape, {0, 0}, {1, 0});
    std::vector<Vec<2>> points = relaxed(*shape, 0.05).points;
    std::vector<Vec<2>> images = relaxed(*image, 0.05).points;
    for (Vec<2>& x : images) x[0] = -x[0];
    sortPlaces(points);
    sortPlaces(images);
    CHECK(points == images);

    SECTION("also one that is its own image") {
        std::vector<Vec<2>> disc = relaxed(*geometry::makeBall<2>({0, 0}, 1), 0.02).points;
        std::vector<Vec<2>> mirrored = disc;
        for (Vec<2>& x : mirrored) x[1] = -x[1];
        sortPlaces(disc);
        sortPlaces(mirrored);
        CHECK(disc == mirrored);
    }
}

TEST_CASE("two bodies that share an interface stand half a spacing from it on both sides") {
    const double spacing = 0.05;
    const auto disc = geometry::makeBall<2>({0, 0}, 1);
    const auto around = geometry::makeDifference<2>({geometry::makeBall<2>({0, 0}, 1.3), disc});
    const Relaxed<2> inside = relaxed(*disc, spacing), outside = relaxed(*around, spacing);
    double least = 1;
    for (const Vec<2>& x : inside.points) least = std::min(least, nearest(outside.points, x));
    CHECK(least > 0.9999 * spacing);
    CHECK(least < 1.02 * spacing);
    for (const Vec<2>& x : outside.points) CHECK(!disc->contains(x));
}

TEST_CASE("a shape that is thinner than a spacing is told") {
    const auto plate = geometry::makeBox<2>({0, 0.01}, {1, 0.04});
    const Relaxed<2> found = relaxed(*plate, 0.05);
    REQUIRE(found.thin);
    CHECK(plate->contains(*found.thin));
    CHECK(!relaxed(*geometry::makeBox<2>({0, 0}, {1, 0.1}), 0.05).thin);
}

TEST_CASE("a relaxation that is cut short says so") {
    const Relaxed<2> found = relaxed(*geometry::makeBall<2>({0, 0}, 1), 0.05,
                                     KernelType::wendland_c2, {.residual = 5e-3, .steps = 60});
    CHECK(!found.converged);
    CHECK(found.steps == 60);
    CHECK(found.residual > 5e-3);
}

TEST_CASE("of a shape without a volume there is nothing") {
    const auto ball = geometry::makeBall<3>({0, 0, 0}, 1);
    const auto larger = geometry::makeBall<3>({0, 0, 0}, 1.5);
    CHECK(relaxed(*geometry::makeDifference<3>({ball, larger}), 0.25).points.empty());
    const auto far = geometry::makeBall<2>({5, 0}, 1);
    const auto none = geometry::makeIntersection<2>({geometry::makeBall<2>({0, 0}, 1), far});
    CHECK(relaxed(*none, 0.25).points.empty());
}
