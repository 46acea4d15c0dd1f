// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/terms/riemann.h"
#include "dynamics/pair.h"

#include <limits>

// The terms of the acoustic step between a fluid particle and a dummy particle of a wall: one-sided
// Riemann problem along the wall's normal, Zhang, Hu & Adams 2017, doi:10.1016/j.jcp.2017.01.027.
// An elastic solid is met along e_ij in place of its normal: pressure pushes along e_ij, and only
// if the density counts the motion of the solid along the same line is the work of the pressure on
// the solid taken from the fluid. A rigid wall does as it is told whatever the work, and the normal
// leaves a fluid that slides along it alone.
// Number is double for one pair or Lanes for eight. The fluid's and the wall's side get the same
// numbers, so what one loses the other gains. In a pair e_ij points from the wall to the fluid.
namespace sphinx::dynamics::fluid {

/// The fluid's side of a pair.
template <int Dim, class Number>
struct FluidSide {
    Number v[Dim];
    Number g[Dim];  ///< acceleration by other forces than pressure
    Number p;
    Number rho;
    /// Least pressure between it and a wall: 0 where the wall cannot hold it.
    Number least = everywhere<Number>(-std::numeric_limits<double>::infinity());
    /// Least acceleration towards the wall that the pressure of the ghost counts.
    Number least_pull = {};
};

/// The wall's side of a pair.
template <int Dim, class Number>
struct WallSide {
    Number v[Dim];
    Number a[Dim] = {};
    Number n[Dim];
};

/// Turns the wall's normal towards the fluid and returns -(v_i - v_w) . n: closing in.
template <int Dim, class Number>
[[gnu::always_inline]] inline Number closingSpeed(const Number (&v)[Dim],
                                                  WallSide<Dim, Number>& wall,
                                                  const Pair<Dim, Number>& pair) {
    // The gradient -abs(W') e_ij points to the wall.
    const Number sign = -signOf<Number>(dot<Dim>(wall.n, pair.gradient));
    Number closing[Dim];
    for (int c = 0; c < Dim; ++c) {
        wall.n[c] = sign * wall.n[c];
        closing[c] = wall.v[c] - v[c];
    }
    return dot<Dim>(closing, wall.n);
}

/// Twice the pressure p* of the one-sided Riemann problem: p_i, the pressure of the ghost
/// p_i + rho_i r_ij max(least_pull, -(g_i - a_w) . e_ij), and what closing in at twice the speed
/// adds, since the ghost moves with the mirrored normal velocity; p* is no less than what the wall
/// can pull with. `r`: distance of the two.
template <Riemann R, int Dim, class Number>
[[gnu::always_inline]] inline Number twiceWallPressure(const RiemannConstants& k,
                                                       const FluidSide<Dim, Number>& fluid,
                                                       WallSide<Dim, Number> wall,
                                                       const Pair<Dim, Number>& pair, Number r) {
    const auto two = static_cast<ScalarOf<Number>>(2);
    Number g[Dim];
    for (int c = 0; c < Dim; ++c) g[c] = fluid.g[c] - wall.a[c];
    const Number pull = dot<Dim>(g, pair.gradient);  // (g_i - a_w) . (-e_ij) abs(W')
    const Number ghost = fluid.rho * r * larger<Number>(pull * pair.inverse_dW, fluid.least_pull);
    const Number closing = closingSpeed<Dim>(fluid.v, wall, pair);
    const Number p2 = two * fluid.p + ghost + pressureJump<R>(k, two * closing);
    return larger<Number>(p2, two * fluid.least);
}

/// 2 (v_i - v*_ij) . e_ij W' at a wall, where the ghost has the fluid's own pressure above the
/// hydrostatic: drho_i/dt is rho_i times its sum over V_j.
template <int Dim, class Number>
[[gnu::always_inline]] inline Number wallClosingRate(const Number (&v)[Dim],
                                                     WallSide<Dim, Number> wall,
                                                     const Pair<Dim, Number>& pair) {
    const Number closing = closingSpeed<Dim>(v, wall, pair);
    return static_cast<ScalarOf<Number>>(-2) * closing * dot<Dim>(wall.n, pair.gradient);
}

}  // namespace sphinx::dynamics::fluid
