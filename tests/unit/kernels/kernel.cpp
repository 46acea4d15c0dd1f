// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "kernels/kernel.h"

#include "core/lanes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace sphinx;
using namespace sphinx::kernels;

namespace {

constexpr double h = 0.13;
constexpr double spacing = 0.1;

struct Expected {
    KernelType type;
    std::string name;
    int reach;  // in smoothing lengths, where pieces meet at whole numbers
};
const std::vector<Expected> all_kernels = {{KernelType::wendland_c2, "Wendland C2", 2},
                                           {KernelType::cubic_spline, "cubic spline", 2},
                                           {KernelType::quintic_spline, "quintic spline", 3}};

/// Of f from a to b by Simpson's rule.
template <class F>
double integral(double a, double b, F&& f) {
    constexpr int n = 200;
    double sum = f(a) + f(b);
    for (int i = 1; i < n; ++i) sum += (i % 2 ? 4 : 2) * f(a + (b - a) * i / n);
    return sum * (b - a) / (3 * n);
}

/// Points within `reach` of the origin, itself included, of the lattice made of whole multiples of
/// the vectors (columns of a triangle), scaled to the volume spacing^Dim for each point.
template <int Dim>
std::vector<Vec<Dim>> lattice(Mat<Dim> vectors, double reach) {
    vectors *= spacing / std::pow(vectors.diagonal().prod(), 1.0 / Dim);
    constexpr int n = 12;
    std::vector<Vec<Dim>> points;
    for (int k = Dim == 3 ? -n : 0; k <= (Dim == 3 ? n : 0); ++k)
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i) {
                Vec<Dim> x = i * vectors.col(0) + j * vectors.col(1);
                if constexpr (Dim == 3) x += k * vectors.col(2);
                if (x.norm() < reach) points.push_back(x);
            }
    return points;
}

/// Hexagonal, or face-centred cubic: vectors to three corners of a tetrahedron.
template <int Dim>
Mat<Dim> densest() {
    Mat<Dim> vectors;
    if constexpr (Dim == 2)
        vectors << 1, 0.5, 0, 0.5 * std::sqrt(3.0);
    else
        vectors << 1, 0.5, 0.5, 0, 0.5 * std::sqrt(3.0), std::sqrt(3.0) / 6, 0, 0,
            std::sqrt(2.0 / 3.0);
    return vectors;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a kernel", "", ((int Dim), Dim), 2, 3) {
    for (const Expected& expected : all_kernels) {
        INFO(expected.name << " in " << Dim << "D");
        const Kernel<Dim> kernel(expected.type, h, spacing);
        const double peak = kernel.value(0);

        // Integrates to 1 over circles (spheres).
        double total = 0;
        for (int piece = 0; piece < expected.reach; ++piece)
            total += integral(piece * h, (piece + 1) * h, [&](double r) {
                const double around =
                    Dim == 2 ? 2 * std::numbers::pi * r : 4 * std::numbers::pi * r * r;
                return around * kernel.value(r);
            });
        CHECK(total == Approx(1).epsilon(1e-9));

        // Falls, with the derivative it says, down to nothing at its reach.
        CHECK(kernel.cutoff() == Approx(expected.reach * h).epsilon(1e-15));
        constexpr double step = 1e-5 * h;
        for (double q = 0.005; q < expected.reach; q += 0.01) {
            INFO("at " << q << " smoothing lengths");
            const double r = q * h;
            const double difference =
                (kernel.value(r + step) - kernel.value(r - step)) / (2 * step);
            CHECK(std::abs(kernel.derivative(r) - difference) < 1e-8 * peak / h);
            CHECK(kernel.value(r) > 0);
            CHECK(kernel.derivative(r) < 0);
        }
        CHECK(kernel.derivative(0) == 0);
        for (const double r : {kernel.cutoff(), 1.001 * kernel.cutoff(), 10 * h}) {
            CHECK(kernel.value(r) == 0);
            CHECK(kernel.derivative(r) == 0);
        }
        CHECK(kernel.value(0.999 * kernel.cutoff()) < 1e-8 * peak);
    }
}

TEMPLATE_TEST_CASE_SIG("the sum of a kernel over a lattice", "", ((int Dim), Dim), 2, 3) {
    for (const Expected& expected : all_kernels) {
        INFO(expected.name << " in " << Dim << "D");
        const Kernel<Dim> kernel(expected.type, h, spacing);
        double sum = 0;
        for (const Vec<Dim>& x : lattice<Dim>(Mat<Dim>::Identity(), kernel.cutoff()))
            sum += kernel.value(x.norm());
        CHECK(kernel.latticeSum() == Approx(sum).epsilon(1e-14));
        // A row and what is on one side of it: half of the row itself counts twice.
        double row = 0;
        for (const Vec<Dim>& x : lattice<Dim>(Mat<Dim>::Identity(), kernel.cutoff()))
            if (std::abs(x[1]) < 0.5 * spacing) row += kernel.value(x.norm());
        CHECK(kernel.surfaceSum() == Approx(0.5 * (sum + row)).epsilon(1e-14));
        // That is nearly the integral.
        CHECK(kernel.latticeSum() * std::pow(spacing, Dim) == Approx(1).epsilon(0.015));
    }
}

TEMPLATE_TEST_CASE_SIG("normalised gradients", "", ((int Dim), Dim), 2, 3) {
    const double volume = std::pow(spacing, Dim);
    for (const Expected& expected : all_kernels) {
        INFO(expected.name << " in " << Dim << "D");
        const Kernel<Dim> kernel(expected.type, h, spacing);
        const double factor = kernel.gradientFactor();

        // Of a linear field, in the densest lattice: sum_j V_j r_ij (x) grad W = -1.
        Mat<Dim> moment = Mat<Dim>::Zero();
        for (const Vec<Dim>& x : lattice<Dim>(densest<Dim>(), kernel.cutoff()))
            if (const double r = x.norm(); r > 0)
                moment += factor * volume * x * (kernel.derivative(r) / r * x).transpose();
        CHECK((moment + Mat<Dim>::Identity()).norm() < 1e-12);

        // The Laplacian of x^2, of xy and of the sum of all squares, in the square (cubic) lattice.
        double of_one = 0;
        double mixed = 0;
        double of_all = 0;
        for (const Vec<Dim>& x : lattice<Dim>(Mat<Dim>::Identity(), kernel.cutoff())) {
            const double r = x.norm();
            if (r == 0) continue;
            const double weight =
                -2 * volume * factor * kernel.laplacianFactor() * kernel.derivative(r) / r;
            of_one += weight * x[0] * x[0];
            mixed += weight * x[0] * x[1];
            of_all += weight * x.squaredNorm();
        }
        CHECK(of_one == Approx(2).epsilon(1e-12));
        CHECK(std::abs(mixed) < 1e-12);
        CHECK(of_all == Approx(2 * Dim).epsilon(1e-12));
        CHECK(factor == Approx(1).epsilon(0.03));
        CHECK(kernel.laplacianFactor() == Approx(1).epsilon(0.03));
    }
}

TEST_CASE("the gradients of Wendland C2 in 2D at h = 1.3 spacings need 1.5 percent") {
    CHECK(Kernel<2>(KernelType::wendland_c2, 1.3, 1).gradientFactor() ==
          Approx(1.015).epsilon(1e-3));
}

TEMPLATE_TEST_CASE_SIG("shapes of eight distances are those of each", "", ((int Dim), Dim), 2, 3) {
    for (const Expected& expected : all_kernels) {
        INFO(expected.name << " in " << Dim << "D");
        withKernel<Dim>(expected.type, [&]<class K>() {
            CHECK(K::reach == expected.reach);
            double q[lane_count];
            for (int k = 0; k < lane_count; ++k) q[k] = (k + 0.5) / lane_count * K::reach;
            const Lanes w = K::template w<Lanes>(loadLanes(q));
            const Lanes slope = K::template dwOverQ<Lanes>(loadLanes(q));
            for (int k = 0; k < lane_count; ++k) {
                CHECK(w[k] == Approx(K::template w<double>(q[k])).epsilon(1e-14));
                CHECK(slope[k] == Approx(K::template dwOverQ<double>(q[k])).epsilon(1e-14));
            }
            // The slope has a limit at 0.
            CHECK(K::dwOverQ(0.0) == Approx(K::dwOverQ(1e-9)).epsilon(1e-6));
        });
    }
}
