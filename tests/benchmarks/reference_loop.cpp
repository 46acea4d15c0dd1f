// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// The yardstick of scripts/bench: both interaction sums of one acoustic step in 2D, pressure
// gradient and continuity, on one core. A plain list of neighbors (offsets, indices, stored
// gradients), flat arrays of double, loops that the compiler vectorises; no wall, no Riemann term,
// no time step. It shares no code with the engine, so that it stays as it is.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

namespace {

constexpr double h = 1.3;  // spacing is 1
constexpr double cutoff = 2 * h;

/// Derivative of Wendland's C2 kernel in 2D by the distance.
double kernelSlope(double r) {
    const double a = 1 - 0.5 * r / h;
    return 7 / (4 * std::numbers::pi) / (h * h * h) * -5 * (r / h) * a * a * a;
}

/// A square lattice, shaken a little, row by row, and its list of neighbors.
struct Particles {
    std::vector<double> vx, vy, p, ax, ay, rate;
    std::vector<std::uint64_t> first;
    std::vector<std::uint32_t> index;
    std::vector<double> gx, gy;  // e_ij W'_ij V_j

    explicit Particles(int side) {
        const int n = side * side;
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> shake(-0.1, 0.1);
        std::vector<double> x(n), y(n);
        for (int i = 0; i < n; ++i) {
            x[i] = i % side + shake(random);
            y[i] = i / side + shake(random);
        }
        for (auto* values : {&vx, &vy, &p}) {
            values->resize(n);
            for (double& value : *values) value = shake(random);
        }
        for (auto* values : {&ax, &ay, &rate}) values->resize(n);
        for (int i = 0; i < n; ++i) {
            first.push_back(index.size());
            const int row = i / side, column = i % side;
            for (int r = std::max(row - 3, 0); r <= std::min(row + 3, side - 1); ++r) {
                for (int c = std::max(column - 3, 0); c <= std::min(column + 3, side - 1); ++c) {
                    const int j = r * side + c;
                    const double distance = std::hypot(x[i] - x[j], y[i] - y[j]);
                    if (j == i || distance >= cutoff) continue;
                    const double slope = kernelSlope(distance) / distance;
                    index.push_back(static_cast<std::uint32_t>(j));
                    gx.push_back(slope * (x[i] - x[j]));
                    gy.push_back(slope * (y[i] - y[j]));
                }
            }
        }
        first.push_back(index.size());
    }

    void pressureGradient() {
        for (std::size_t i = 0; i < ax.size(); ++i) {
            const double pi = p[i];
            double sum_x = 0, sum_y = 0;
#pragma omp simd reduction(+ : sum_x, sum_y)
            for (std::uint64_t k = first[i]; k < first[i + 1]; ++k) {
                const double f = pi + p[index[k]];
                sum_x -= f * gx[k];
                sum_y -= f * gy[k];
            }
            ax[i] = sum_x;
            ay[i] = sum_y;
        }
    }

    void continuity() {
        for (std::size_t i = 0; i < rate.size(); ++i) {
            const double vxi = vx[i], vyi = vy[i];
            double sum = 0;
#pragma omp simd reduction(+ : sum)
            for (std::uint64_t k = first[i]; k < first[i + 1]; ++k)
                sum += (vxi - vx[index[k]]) * gx[k] + (vyi - vy[index[k]]) * gy[k];
            rate[i] = sum;
        }
    }
};

}  // namespace

/// Prints one line of JSON with the median time over many passes. Argument: particles, about.
int main(int argc, char** argv) {
    const int wanted = argc > 1 ? std::atoi(argv[1]) : 50000;
    if (argc > 2 || wanted < 100 || wanted > 10'000'000) {
        std::fprintf(stderr, "usage: reference_loop [PARTICLES]\n");
        return 2;
    }
    Particles particles(static_cast<int>(std::lround(std::sqrt(wanted))));
    const double n = static_cast<double>(particles.p.size());

    using Now = std::chrono::steady_clock;
    const auto end = Now::now() + std::chrono::milliseconds(700);
    std::vector<double> passes;  // ns per particle
    double sum = 0;              // keeps the results alive
    while (Now::now() < end || passes.size() < 5) {
        const auto start = Now::now();
        particles.pressureGradient();
        particles.continuity();
        const std::chrono::duration<double, std::nano> duration = Now::now() - start;
        passes.push_back(duration.count() / n);
        sum += particles.ax[0] + particles.ay[0] + particles.rate[0];
    }
    const auto middle = passes.begin() + static_cast<std::ptrdiff_t>(passes.size() / 2);
    std::nth_element(passes.begin(), middle, passes.end());
    std::printf(
        "{\"particles\": %.0f, \"neighbors\": %.2f, \"passes\": %zu, \"ns_per_particle\": %.3f, "
        "\"checksum\": %g}\n",
        n, static_cast<double>(particles.index.size()) / n, passes.size(), *middle, sum);
    return 0;
}
