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

/// Viscosity of a pair of tiles: the geometric mean sqrt(mu_i mu_j). Particles of one fluid meet,
/// whose viscosity varies without a jump, and any mean does where it varies little. Beside a plug
/// that does not yield, where it falls by its own size from one particle to the next, the harmonic
/// mean is that of the thinner fluid and the arithmetic one that of the thicker: in a
/// one-dimensional model of cases/power_law_channel_2d/herschel_bulkley.yaml at L/20 the plug
/// is 3.0 % too fast with the first, 2.8 % too slow with the second and 0.5 % too fast with this
/// one. Zero where both are zero, as in empty slots.
template <class Tile>
[[gnu::always_inline]] inline Tile geometricMean(Tile a, Tile b) {
    const Tile product = a * b;
    return product * inverseSqrtTile(static_cast<ScalarOf<Tile>>(1e-30) + product);
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
