// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/fluid/viscous_load.h"
#include "dynamics/pair_loop.h"
#include "materials/fluid.h"
#include "neighbors/common_kernel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace sphinx::dynamics::fluid {

/// The viscous force of other liquids on a fluid: that between its own particles (viscous_force.h)
/// with the harmonic mean of the two viscosities, 2 mu_a mu_b/(mu_a + mu_b). The interface lies
/// between the particles of a pair, and across it the shear stress is the same on either side, not
/// the shear: two layers of equal width pass on mu_a mu_b/(mu_a + mu_b) of twice what the whole
/// difference of velocities would make (Hu & Adams 2006, doi:10.1016/j.jcp.2005.09.001). A liquid
/// without viscosity feels nothing and exerts nothing.
///
/// Each liquid sums its own side, of the same numbers.
template <int Dim>
class LiquidFriction {
 public:
    LiquidFriction(const Body<Dim>& body, const Surroundings<Dim>& around, ViscousForm form) {
        for (const auto& liquid : around.liquids()) {
            const Body<Dim>& other = *liquid.body;
            const double mu_a = body.fluid().material->viscosity();
            const double mu_b = other.fluid().material->viscosity();
            if (mu_a == 0 || mu_b == 0) continue;
            const auto& kernel = sphinx::neighbors::commonKernel(body, other);
            const double sums_to =
                form == ViscousForm::laplacian ? kernel.laplacianFactor() : Dim + 2;
            others_.push_back({liquid.relation, liquid.velocity, liquid.volume,
                               2 * sums_to * (2 * (mu_a * mu_b) / (mu_a + mu_b)),
                               std::max(largestViscousSum(body), largestViscousSum(other))});
            bodies_.push_back(liquid.body);
        }
    }

    /// Those that push and are pushed.
    const std::vector<const Body<Dim>*>& bodies() const { return bodies_; }

    /// Adds the force on particle i, of velocity v and volume V, times `scale`.
    template <ViscousForm F>
    void add(Index i, const Vec<Dim>& v, double V, double scale,
             std::array<double, Dim>& force) const {
        for (const Other& other : others_) {
            const NeighborList<Dim>& list = other.relation->list;
            ExactSums<Dim> sum(SumGrid(other.largest / list.gradient_unit));
            Distances<Dim> distances(list, i);
            forEachPair(list, i, [&](const Pairs<Dim>& pair) {
                Lanes v_ij[Dim];
                gatherVectors<Dim>(other.velocity->data(), pair.index, v_ij);
                for (int c = 0; c < Dim; ++c) v_ij[c] = v[c] - v_ij[c];
                const Lanes V_j = gatherLanes(other.volume->data(), pair.index);
                addPairs<F, Dim>(pair, v_ij, distances.next(), V * V_j, sum);
            });
            const double unit = scale * (other.factor * list.gradient_unit);
            for (int c = 0; c < Dim; ++c) force[c] += unit * sum[c].value();
        }
    }

 private:
    struct Other {
        const Relation<Dim>* relation;
        const Field<Vec<Dim>>* velocity;
        const Field<double>* volume;
        double factor;
        double largest;
    };
    std::vector<Other> others_;
    std::vector<const Body<Dim>*> bodies_;
};

}  // namespace sphinx::dynamics::fluid
