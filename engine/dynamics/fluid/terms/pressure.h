// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/terms/riemann.h"
#include "dynamics/pair.h"

// The terms of the acoustic step between two particles of a fluid, guide (56) to (58). Number is
// double for one pair or Lanes for eight. v_ij = v_i - v_j.
namespace sphinx::dynamics::fluid {

/// Twice the pressure of the Riemann problem: the force on i is -2 p*_ij e_ij W' V_i V_j. Pressure.
template <Riemann R, int Dim, class Number>
[[gnu::always_inline]] inline Number twicePressure(const RiemannConstants& k,
                                                   const Pair<Dim, Number>& pair,
                                                   const Number (&v_ij)[Dim], Number p_i,
                                                   Number p_j) {
    // v_ij . e_ij W' > 0 where the particles close in
    const Number approach = dot<Dim>(v_ij, pair.gradient);
    return p_i + p_j + pressureJump<R>(k, approach * pair.inverse_dW);
}

/// 2 (v_i - v*_ij) . e_ij W': drho_i/dt is rho_i times its sum over V_j. `p_ij`: p_i - p_j.
template <Riemann R, int Dim, class Number>
[[gnu::always_inline]] inline Number closingRate(const RiemannConstants& k,
                                                 const Pair<Dim, Number>& pair,
                                                 const Number (&v_ij)[Dim], Number p_ij) {
    return dot<Dim>(v_ij, pair.gradient) - pair.dW * velocityJump<R>(k, p_ij);
}

}  // namespace sphinx::dynamics::fluid
