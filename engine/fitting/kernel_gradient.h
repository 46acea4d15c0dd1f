// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "fitting/outside.h"
#include "fitting/reach_list.h"
#include "geometry/shape.h"
#include "kernels/kernel.h"
#include "particles/lattice.h"

namespace sphinx::fitting {

/// -sum_j V_j grad W_ij over particles of one volume and over all that lies outside of their shape,
/// as if they went on there: zero where they are spread evenly, up to the surface. (Static
/// confinement; here the outside is a sum over cells, right at corners and tips as well.)
template <int Dim>
class KernelGradient {
 public:
    KernelGradient(const geometry::Shape<Dim>& shape, const particles::Lattice<Dim>& lattice,
                   const kernels::Kernel<Dim>& kernel);

    /// Finds `gradient` (1/length) anew where a particle that has moved is in reach; elsewhere it
    /// is left as it was. Each sum is exact: its bits know nothing of order, threads and mirroring.
    void compute(const AlignedVector<Vec<Dim>>& position, const AlignedVector<std::uint8_t>& moved,
                 double volume, AlignedVector<Vec<Dim>>& gradient);

    /// Size of the sum at the edge of a half space: what the missing half of the neighbors would
    /// make. 1/length.
    double reference() const { return reference_; }
    /// Largest stiffness of a particle in the lattice. 1/length^2.
    double stiffness() const { return stiffness_; }

 private:
    template <class K>
    void sum(const AlignedVector<std::uint8_t>& moved, AlignedVector<Vec<Dim>>& gradient);

    /// What a sum reads of a neighbor, in one load.
    struct alignas(32) Source {
        double x[3];
        double volume;
    };

    kernels::Kernel<Dim> kernel_;
    double reference_;
    double stiffness_;
    Outside<Dim> outside_;
    ReachList<Dim> list_;
    AlignedVector<Source> sources_;  // particles, then what is outside
};

extern template class KernelGradient<2>;
extern template class KernelGradient<3>;

}  // namespace sphinx::fitting
