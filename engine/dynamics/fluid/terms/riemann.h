// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/number.h"

namespace sphinx::dynamics::fluid {

enum class Riemann { none, dissipative, low_dissipation };

/// Linearised Riemann problem between i (left) and j (right) along -e_ij, with the impedance
/// rho0 c0 of the weakly compressible fluid on both sides; Zhang, Hu & Adams 2017,
/// doi:10.1016/j.jcp.2017.01.027:
///   p* = (p_i + p_j)/2 + beta rho0 (U_L - U_R)/2,   U* = (U_L + U_R)/2 + (p_L - p_R)/(2 rho0 c0),
/// beta = c0 (dissipative) or min(3 max(U_L - U_R, 0), c0) (low_dissipation: nothing is lost where
/// particles move apart and little in smooth flow).
struct RiemannConstants {
    double rho0 = 0;  ///< density
    double c0 = 0;    ///< sound speed
};

/// 2 p* - p_i - p_j, from the closing speed U_L - U_R = -v_ij . e_ij.
template <Riemann R, class Number>
[[gnu::always_inline]] inline Number pressureJump(const RiemannConstants& k, Number closing) {
    if constexpr (R == Riemann::none) return Number{};
    using Scalar = ScalarOf<Number>;
    const auto rho0 = static_cast<Scalar>(k.rho0);
    const auto c0 = static_cast<Scalar>(k.c0);
    if constexpr (R == Riemann::dissipative) return rho0 * c0 * closing;
    const Number beta =
        smaller<Number>(Scalar{3} * larger<Number>(closing, Number{}), everywhere<Number>(k.c0));
    return rho0 * beta * closing;
}

/// 2 (U* - (U_L + U_R)/2), from p_i - p_j.
template <Riemann R, class Number>
[[gnu::always_inline]] inline Number velocityJump(const RiemannConstants& k,
                                                  Number pressure_difference) {
    if constexpr (R == Riemann::none) return Number{};
    return pressure_difference * static_cast<ScalarOf<Number>>(1 / (k.rho0 * k.c0));
}

/// f(Riemann R as a template argument).
template <class F>
void withRiemann(Riemann riemann, F&& f) {
    switch (riemann) {
        case Riemann::none: return f.template operator()<Riemann::none>();
        case Riemann::dissipative: return f.template operator()<Riemann::dissipative>();
        case Riemann::low_dissipation: return f.template operator()<Riemann::low_dissipation>();
    }
}

}  // namespace sphinx::dynamics::fluid
