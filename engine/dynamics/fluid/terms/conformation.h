// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <Eigen/LU>
#include <cmath>

// How the conformation of polymers changes in a step; pure functions.
namespace sphinx::dynamics::fluid {

/// What a velocity gradient deforms in a time: (1 - L t/2)^-1 (1 + L t/2), the exponential of L t
/// to second order. Of a rigid rotation it is a rotation to the last digits.
template <int Dim>
Mat<Dim> deformed(const Mat<Dim>& L, double time) {
    const Mat<Dim> half = 0.5 * time * L;
    const Mat<Dim> one = Mat<Dim>::Identity();
    return (one - half).inverse() * (one + half);
}

/// The conformation after a step dt of dc/dt = L c + c L^T - (c - 1)/lambda, guide (20) for
/// tau_p = eta_p (c - 1)/lambda with L_ab = dv_a/dx_b. The solution for a constant L,
///   c(dt) = a F(dt) c F(dt)^T + int_0^dt exp(-s/lambda) F(s) F(s)^T ds/lambda,  F(s) = exp(L s),
/// a = exp(-dt/lambda), with the integral at the mean age of what has relaxed in the step,
///   (1 - a) F(s*) F(s*)^T,  s* = lambda - dt a/(1 - a):
/// second order in dt, and for dt >> lambda the Newtonian 1 + 2 lambda D. Both terms are
/// congruences with positive weights, so c stays symmetric and positive at any step and Weissenberg
/// number; a fluid that turns as a rigid body turns its c.
template <int Dim>
Mat<Dim> relaxedConformation(const Mat<Dim>& c, const Mat<Dim>& L, double dt, double lambda) {
    const double relaxed = -std::expm1(-dt / lambda);  // 1 - a
    const double kept = 1 - relaxed;
    const double age = lambda * (1 - dt / lambda * kept / relaxed);
    const Mat<Dim> F = deformed<Dim>(L, dt);
    const Mat<Dim> G = deformed<Dim>(L, age);
    const Mat<Dim> sum = kept * (F * c * F.transpose()) + relaxed * (G * G.transpose());
    return 0.5 * (sum + sum.transpose());
}

}  // namespace sphinx::dynamics::fluid
