// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/words.h"
#include "materials/oldroyd_b_fluid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// How large a step the stress of polymers bears.
namespace sphinx::dynamics::fluid {

/// Of the waves of a lattice the largest abs(sum_j V_j e_ij W' sin(k . r_ij)), 1/length: of what a
/// gradient makes the most. Along an axis and along a diagonal.
template <int Dim>
double largestGradient(const Kernel<Dim>& kernel, double spacing) {
    const int n = static_cast<int>(std::ceil(kernel.cutoff() / spacing));
    const int depth = Dim == 3 ? n : 0;
    double largest = 0;
    for (const bool diagonal : {false, true})
        for (int wave = 1; wave < 32; ++wave) {
            const double k = wave * std::numbers::pi / 32;
            double sum = 0;
            for (int a = -n; a <= n; ++a)
                for (int b = -n; b <= n; ++b)
                    for (int c = -depth; c <= depth; ++c) {
                        const double r = spacing * std::sqrt(double(a * a + b * b + c * c));
                        if (!(r > 0) || r >= kernel.cutoff()) continue;
                        const int along = diagonal ? a + b + c : a;
                        sum -= kernel.derivative(r) * spacing * a / r * std::sin(k * along);
                    }
            const double axes = diagonal ? std::sqrt(double(Dim)) : 1;
            largest = std::max(largest, axes * sum);
        }
    return largest * std::pow(spacing, Dim) * kernel.gradientFactor();
}

template <int Dim>
double largestTrace(const Body<Dim>& body, const Field<Mat<Dim>>& conformation) {
    return maxAll(body.size(), double(Dim), [&](std::size_t i) { return conformation[i].trace(); });
}

/// Half of the largest stable step. A wave of wave number k has the frequency omega, omega^2 =
/// eta_p/(lambda rho) (k . c . k), if nothing relaxes. Stress and velocity stepped by turns,
/// tau = a tau + eta_p (1 - a) k v, v -= dt/rho k tau with a = exp(-dt/lambda), are stable for
/// omega^2 lambda dt tanh(dt/(2 lambda)) <= 2: so they are up to 2/omega, and up to 2/(omega^2
/// lambda), where polymers are but a viscosity. `trace`: of the largest c, no less than its largest
/// eigenvalue.
inline double elasticStep(const materials::OldroydBFluid& fluid, double trace, double gradient) {
    const double omega2 = fluid.modulus() * trace / fluid.density() * gradient * gradient;
    return std::max(1 / std::sqrt(omega2), 1 / (omega2 * fluid.relaxationTime()));
}

}  // namespace sphinx::dynamics::fluid
