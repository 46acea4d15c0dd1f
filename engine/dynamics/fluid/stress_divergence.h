// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "dynamics/tile_loop.h"

namespace sphinx::dynamics::fluid {

/// Force of a stress T within a fluid, F_i = sum_j (T_i B_i + T_j B_j) . e_ij W' V_i V_j over its
/// own particles, with the correction of VelocityGradient: what one particle gets the other loses,
/// and the work of F is minus that of T, sum_i F_i . v_i = -sum_i V_i T_i : L_i (but for walls).
template <int Dim>
class StressDivergence {
 public:
    /// `stress`: T_i B_i of n particles. `volume`: of each of them; `spacing`: of the lattice.
    void find(const PairTiles<Dim>& tiles, const AlignedVector<Mat<Dim>>& stress,
              const Field<double>& volume, double spacing);
    const AlignedVector<Vec<Dim>>& force() const { return force_; }

 private:
    template <class Real>
    void sum(const PairTiles<Dim>& tiles, const AlignedVector<Mat<Dim>>& stress,
             const Field<double>& volume, double cell, double largest);

    // Filled anew in every call: a row of the stress in units of the largest, in the place of a
    // velocity.
    TileRecords<Dim> records_;
    TileSums<Dim, 1> sums_;
    AlignedVector<Vec<Dim>> force_;
};

extern template class StressDivergence<2>;
extern template class StressDivergence<3>;

}  // namespace sphinx::dynamics::fluid
