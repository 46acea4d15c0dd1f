// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/terms/riemann.h"
#include "dynamics/pair.h"

// The terms of the acoustic step between particles of two liquids. Number is double for one pair or
// Lanes for eight. v_ij = v_i - v_j.
namespace sphinx::dynamics::fluid {

/// Of two liquids a and b, as a particle i of a sees a particle j of b. With the shares
/// s_a = rho_a/(rho_a + rho_b) of the densities rho0, s_b = 1 - s_a:
///   p* = s_b p_i + s_a p_j + Z beta (U_L - U_R),   v* = s_a v_i + s_b v_j,
///   Z = Z_a Z_b/(Z_a + Z_b) of the impedances rho0 c0.
/// The jump is that of the linearised Riemann problem of two impedances (Rezavand, Zhang & Hu 2020,
/// doi:10.1016/j.jcp.2019.109092), limited by beta = min(3 max(U_L - U_R, 0)/c, 1) with their
/// c = s_a c_a + s_b c_b. What lies between is weighted with densities, where that has impedances
/// (both are the same for equal sound speeds): then particles beside the interface have one
/// acceleration grad p/rho (Hu & Adams 2007, doi:10.1016/j.jcp.2007.07.013), also at rest, where it
/// is g on either side. Pressures have the weights of the other liquid's velocities, so that what
/// the pressures of the pair do is the work that compresses the two.
///
/// U_L - U_R is across the interface, (v_i - v_j) . n_ij with n_ij from i to j, not along the line
/// of the two: liquids without viscosity slide along each other, and along the line the jump would
/// brake them (by half within three periods of a wave between them, whatever its amplitude).
///
/// v* has no jump of the pressures: it would spread density from one liquid to the other, and is
/// known only less the hydrostatic pressure between the particles, which depends on where the
/// interface runs between them. Each liquid spreads its own, as at a wall.
///
/// Of two equal liquids these are the terms within one (terms/pressure.h), less that jump.
struct Interface {
    double own = 0;         ///< s_a
    double other = 0;       ///< s_b
    RiemannConstants both;  ///< of a liquid with the impedance 2 Z, and c
};
inline Interface interfaceOf(const RiemannConstants& a, const RiemannConstants& b) {
    const double sum = a.rho0 + b.rho0;
    // Products and sums of the two: both liquids get the same bits.
    const double Z_a = a.rho0 * a.c0;
    const double Z_b = b.rho0 * b.c0;
    const double c = (Z_a + Z_b) / sum;
    return {a.rho0 / sum, b.rho0 / sum, {2 * (Z_a * Z_b) / ((Z_a + Z_b) * c), c}};
}

/// Twice p*: the force on i is -2 p*_ij e_ij W' V_i V_j. Pressure. `closing`: U_L - U_R.
template <Riemann R, class Number>
[[gnu::always_inline]] inline Number twiceInterfacePressure(const Interface& k, Number closing,
                                                            Number p_i, Number p_j) {
    using Scalar = ScalarOf<Number>;
    const Number mean =
        static_cast<Scalar>(2 * k.other) * p_i + static_cast<Scalar>(2 * k.own) * p_j;
    return mean + pressureJump<R>(k.both, closing);
}

/// 2 (v_i - v*_ij) . e_ij W': drho_i/dt is rho_i times its sum over V_j.
template <int Dim, class Number>
[[gnu::always_inline]] inline Number interfaceClosingRate(const Interface& k,
                                                          const Pair<Dim, Number>& pair,
                                                          const Number (&v_ij)[Dim]) {
    return static_cast<ScalarOf<Number>>(2 * k.other) * dot<Dim>(v_ij, pair.gradient);
}

}  // namespace sphinx::dynamics::fluid
