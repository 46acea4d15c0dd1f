// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exact_sum.h"
#include "dynamics/fluid/no_slip_pairs.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/stress_divergence.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/fluid/velocity_gradient.h"
#include "dynamics/fluid/velocity_steps.h"
#include "dynamics/fluid/viscous_force.h"
#include "dynamics/tile_loop.h"
#include "materials/generalised_newtonian.h"

#include <cmath>
#include <optional>
#include <vector>

namespace sphinx::dynamics::fluid {

template <class F>
decltype(auto) withForm(ViscousForm form, F&& f) {
    if (form == ViscousForm::laplacian) return f.template operator()<ViscousForm::laplacian>();
    return f.template operator()<ViscousForm::central>();
}

/// Adds the term of eight pairs, in the list's gradient unit.
template <ViscousForm F, int Dim>
inline void addPairs(const Pairs<Dim>& pair, const Lanes (&v_ij)[Dim], Lanes r, Lanes V,
                     ExactSums<Dim>& sum) {
    const Lanes f = viscousFactor<F, Dim, Lanes>(pair, v_ij, r, V);
    const auto& direction = viscousDirection<F, Dim, Lanes>(pair, v_ij);
    for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, direction[c]);
}

/// That sums of these terms may reach. Weakly compressible: speeds stay below a tenth of that of
/// sound. sum_j abs(W')/r V_j is a few 1/spacing^2.
template <int Dim>
double largestViscousSum(const Body<Dim>& fluid) {
    return fluid.fluid().material->soundSpeed() * std::pow(fluid.spacing, Dim - 2);
}

/// The weight of a pair is abs(W')/r, where sums are made for abs(W'): r is about 2^28 places.
/// Forces are of the order of v_ij and not of its part along r, so some bits are left for that.
inline constexpr double viscous_places = 0x1p24;

/// Sums over the pairs of a fluid's own particles. Records have velocities in steps
/// (VelocitySteps), volumes in those of a cell, and where the viscosity varies a share of it in the
/// place of the pressure.
/// dW of a tile is its r, so in the laplacian W'/r is the weight times dW/r, which is 1. `Reduced`:
/// it is left out, which saves a division and changes last bits.
template <ViscousForm F, bool Varies, bool Reduced, class Real, int Dim>
void addOwnPairs(const PairTiles<Dim>& tiles, const TileRecords<Dim>& records,
                 TileSums<Dim, Dim>& sums) {
    using Side = TileSide<Dim, Real>;
    using Tile = TileOf<Real>;
    sums.template add<Reaction::opposite, Real>(
        tiles, records,
        [](const Side& i, const Side& j, const TilePairs<Dim, Real>& pair, Tile(&on_i)[Dim],
           Tile(&)[Dim]) {
            Tile v_ij[Dim];
            for (int c = 0; c < Dim; ++c) v_ij[c] = stepsBetween(i.v[c], j.v[c]);
            Tile V = (pair.weight * static_cast<Real>(viscous_places / VelocitySteps::steps)) *
                     (i.V * j.V);
            if constexpr (Varies) V = V * geometricMean<Tile>(i.p, j.p);
            const Tile f = Reduced && F == ViscousForm::laplacian
                               ? -V
                               : viscousFactor<F, Dim, Tile>(pair, v_ij, pair.dW, V);
            const auto& direction = viscousDirection<F, Dim, Tile>(pair, v_ij);
            for (int c = 0; c < Dim; ++c) on_i[c] = f * direction[c];
        });
}

/// One of these sums; times the factor of the force it is one. `speed`: that of the steps.
template <int Dim>
double unitOfOwnPairs(const PairTiles<Dim>& tiles, double speed, double cell) {
    return speed * cell * cell * tiles.gradientUnit() / (viscous_places * tiles.placeUnit());
}

/// The viscous force between a fluid and solids that it sees, as both get it.
template <int Dim>
class ViscousLoad : public SolidLoad<Dim> {
 public:
    Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const override;
    void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const override;

 protected:
    using SolidLoad<Dim>::body_;

    ViscousLoad(Context<Dim>& context, const ViscousForceParameters& p);

    /// Velocities of the fluid of which the force is.
    virtual const Vec<Dim>* felt() const { return velocity_.data(); }
    std::vector<const Body<Dim>*> wallBodies() const;
    /// How the fluidity of a generalised Newtonian fluid goes on at walls.
    void findSlopes() const;

    /// Of a generalised Newtonian fluid: its law, and what it has found.
    struct Varying {
        const materials::GeneralisedNewtonianFluid* law;
        VelocityGradient<Dim> velocity_gradient;
        StressDivergence<Dim> transposed;
        Field<double>& viscosity;
        Field<double>& shear_rate;
        double largest = 0;
        AlignedVector<Mat<Dim>> stress = {};
        OwnGradients<Dim> gradients = {};
        /// Gradient of the fluidity largest/viscosity, empty where there are no walls.
        AlignedVector<Vec<Dim>> slope = {};
        std::uint64_t version = 0;  // of the particles, when it was found
    };
    /// The viscosity of particle i by that in factor_.
    double share(std::size_t i) const {
        return varying_ ? varying_->viscosity[i] / varying_->largest : 1;
    }
    /// The same of eight pairs of a fluid particle with particles of a wall, from the fluidities of
    /// the fluid and their gradients there: the wall's is the fluid's, continued linearly.
    static Lanes shareAtWall(const Pairs<Dim>& pair, Lanes r, Lanes fluidity,
                             const Lanes (&slope)[Dim]) {
        const Lanes at_wall = fluidity + r * pair.inverse_dW * dot<Dim>(slope, pair.gradient);
        return inverseSqrtLanes(fluidity * larger<Lanes>(at_wall, lanes(1)));
    }
    Lanes shareAtWall(const Pairs<Dim>& pair, Lanes r, std::size_t i) const {
        Lanes slope[Dim];
        for (int c = 0; c < Dim; ++c) slope[c] = lanes(varying_->slope[i][c]);
        return shareAtWall(pair, r, lanes(1 / share(i)), slope);
    }

    double nearest_;  // least distance of a fluid particle from a wall that is told apart
    ViscousForm form_;
    double cell_;           // volume of a particle of the lattice
    double per_viscosity_;  // 2 L or 2 (d + 2)
    double factor_;         // times the dynamic viscosity, the largest where it varies
    double largest_;        // that sums over pairs may reach
    mutable std::optional<Varying> varying_;
    Surroundings<Dim> around_;
    TileRecords<Dim> records_;
    TileSums<Dim, Dim> sums_;
    Field<Vec<Dim>>& velocity_;
    Field<double>& mass_;
    Field<double>& volume_;

 private:
    template <ViscousForm F>
    Load<Dim> loadOn(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const;
    template <ViscousForm F>
    void addForces(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const;
};

}  // namespace sphinx::dynamics::fluid
