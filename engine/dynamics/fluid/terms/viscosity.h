// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/pair.h"

// The terms of the viscous force between two particles. Number is double for one pair or Lanes for
// eight. v_ij = v_i - v_j.
namespace sphinx::dynamics::fluid {

enum class ViscousForm { laplacian, central };

/// The term is factor times direction, without 2 mu L or 2 (d + 2) mu; `V` = V_i V_j:
///   laplacian   v_ij W'/r V
///   central     (v_ij . e_ij) e_ij W'/r V
template <ViscousForm F, int Dim, class Number>
[[gnu::always_inline]] inline Number viscousFactor(const Pair<Dim, Number>& pair,
                                                   const Number (&v_ij)[Dim], Number r, Number V) {
    const Number V_over_r = V / larger<Number>(r, everywhere<Number>(1e-30));
    if constexpr (F == ViscousForm::laplacian)
        return -pair.dW * V_over_r;
    else
        return -dot<Dim>(v_ij, pair.gradient) * pair.inverse_dW * V_over_r;
}
template <ViscousForm F, int Dim, class Number>
[[gnu::always_inline]] inline const Number (&viscousDirection(const Pair<Dim, Number>& pair,
                                                              const Number (&v_ij)[Dim]))[Dim] {
    if constexpr (F == ViscousForm::laplacian)
        return v_ij;
    else
        return pair.gradient;
}

/// Viscosity of a pair: that of two halves of a layer one behind the other, of which the stress is the
/// same. Where the viscosity jumps, the force is then that of a continuous stress, and of a thick
/// and a thin fluid the thin one decides; Cleary & Monaghan 1999, doi:10.1006/jcph.1998.6118, for
/// the conductivity. Zero where both are zero, as in empty slots.
template <class Number>
[[gnu::always_inline]] inline Number harmonicMean(Number a, Number b) {
    return static_cast<ScalarOf<Number>>(2) * a * b /
           larger<Number>(a + b, everywhere<Number>(1e-30));
}

/// By how much the velocity difference grows where it is continued linearly into a wall: from the
/// fluid particle's distance to the surface to that plus the depth of the wall particle; Morris,
/// Fox & Zhu 1997, (31)-(32), doi:10.1006/jcph.1997.5776. `n`: the wall's normal, `r`: distance of
/// the two, `nearest`: least distance of a fluid particle from the wall that is told apart.
template <int Dim, class Number>
[[gnu::always_inline]] inline Number continuation(const Pair<Dim, Number>& pair, Number r,
                                                  const Number (&n)[Dim], Number depth,
                                                  double nearest) {
    // Of the two particles, across the wall's surface.
    const Number apart = absolute<Number>(dot<Dim>(n, pair.gradient)) * pair.inverse_dW * r;
    return static_cast<ScalarOf<Number>>(1) +
           depth / larger<Number>(apart - depth, everywhere<Number>(nearest));
}

}  // namespace sphinx::dynamics::fluid
