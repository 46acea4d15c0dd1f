// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "dynamics/context.h"
#include "dynamics/fluid/gradient_sums.h"
#include "dynamics/fluid/surroundings.h"

namespace sphinx::dynamics::fluid {

/// Velocity gradient of a fluid, L_ab = dv_a/dx_b, by a kernel gradient that is exact for linear
/// fields wherever the neighbors stand, also at walls and surfaces:
///   L_i = sum_j (v_j - v_i) (x) B_i e_ij W' V_j,   B_i = (sum_j (r_j - r_i) (x) e_ij W' V_j)^-1,
/// guide (33) with the matrix of Randles & Libersky 1996, doi:10.1016/S0045-7825(96)01090-0, in
/// place of the guide's one number, which is exact only where neighbors lie alike in all
/// directions. A particle of a no-slip wall has the velocity that the viscous force gives it
/// (no_slip_pairs.h), so a shear flow along a wall is linear up to the last particle; walls that
/// the fluid slips along are left out. Made in a method's constructor.
///
/// Of a particle that has all but lost its neighbors the matrix cannot be inverted: where its
/// determinant is below that of a third of a corner of the fluid, L_i and B_i are zero, and a
/// single drop that flies along has no stress.
template <int Dim>
class VelocityGradient {
 public:
    VelocityGradient(Context<Dim>& context, Body<Dim>& body, bool sticks_to_walls);

    /// With the present lists and velocities.
    void find();
    const AlignedVector<Mat<Dim>>& gradient() const { return gradient_; }      ///< L_i
    const AlignedVector<Mat<Dim>>& correction() const { return correction_; }  ///< B_i
    /// Of its lists walls are those that the fluid sticks to.
    Surroundings<Dim>& around() { return around_; }
    const Surroundings<Dim>& around() const { return around_; }

 private:
    template <class Real>
    void sum();
    /// What walls add to the sums of both matrices.
    void addWalls();

    Body<Dim>* body_;
    Surroundings<Dim> around_;
    Field<Vec<Dim>>& velocity_;
    Field<double>& volume_;
    // Filled anew in every call: velocities in steps, volumes in those of a cell.
    TileRecords<Dim> records_;
    GradientSums<Dim> sums_;
    AlignedVector<Mat<Dim>> gradient_;
    AlignedVector<Mat<Dim>> correction_;
};

extern template class VelocityGradient<2>;
extern template class VelocityGradient<3>;

}  // namespace sphinx::dynamics::fluid
