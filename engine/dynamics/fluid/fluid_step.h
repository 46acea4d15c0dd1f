// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aligned.h"
#include "core/exact_sum.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/fluid/terms/interface.h"
#include "dynamics/fluid/terms/riemann.h"
#include "dynamics/tile_loop.h"
#include "materials/fluid.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace sphinx::dynamics::fluid {

/// Acoustic step of a weakly compressible fluid, guide (51) and (56)-(58) read as drift-kick-drift:
///   first half:  rho += dt/2 drho, p(rho), r += dt/2 v, then
///                dv_i = -1/m_i sum_j 2 p*_ij e_ij W' V_i V_j + external,  v += dt dv
///   second half: drho_i = rho_i sum_j 2 (v_i - v*_ij) . e_ij W' V_j,  rho += dt/2 drho, r += dt/2
///   v
/// with p* and v* of the Riemann problem (riemann.h). Each sum runs once a step, and a solid loaded
/// between the halves feels the pressure that the fluid felt.
///
/// The pressures in U* are those above the hydrostatic one, p - rho0 g . r: a fluid at rest is left
/// at rest (Fourtakas et al. 2019, doi:10.1016/j.compfluid.2019.06.009, for the equivalent density
/// diffusion). With p itself the solver takes the weight of the fluid for a jump: the pressure of
/// water at rest is then too high by that of half a spacing at the surface. g is what weighs in the
/// frame of the walls, so that a tank that is shaken does what it does under a force the other way:
/// the mean external acceleration of the fluid less that of all rigid walls which it sees.
/// (That it is not 1.5 % too high everywhere: Kernel::gradientFactor.)
///
/// Solid neighbors are walls of dummy particles, one-sided Riemann problem along the wall's normal
/// n (turned towards the fluid): the ghost has the mirrored normal velocity (free slip) and the
/// pressure p_i + rho_i r_ij max(0, -(g_i - a_w) . e_ij). Where fluids see each other it is without
/// the max: hydrostatic also above the particle. With it a wall at the side bears only a half of
/// what it should of the weight beside it, and oil creeps down along it into water of twice its
/// density: by 4 to 16 spacings in three seconds, at rest as in waves.
///
/// Where the fluid is slack (fields::slack) it has the pressure and the volume of max(rho, rho0),
/// and a wall's p* is not negative: nothing pulls it.
///
/// Phase by phase, so that fluids that see each other are stepped together
/// (pressure_relaxation.cpp). Their pairs have terms of their own (terms/interface.h).
template <int Dim>
class FluidStep final : public SolidLoad<Dim> {
 public:
    FluidStep(Context<Dim>& context, Body<Dim>& body, Riemann riemann);
    /// The step of a fluid that may be one of those which this one sees.
    void meet(const FluidStep& other);

    Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const override;
    void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const override;
    void addImpedance(const Body<Dim>& solid, const NeighborList<Dim>& list,
                      Field<Mat<Dim>>& impedance) const override;
    void transfer(Archive& archive) override {
        SolidLoad<Dim>::transfer(archive);
        archive.value("last_dt", last_dt_);
    }

    // The first half, then the second.
    void predict(const Clock& clock);
    void kick(const Clock& clock);
    void answerSolids(const Clock& clock);
    void compress(const Clock& clock);

 private:
    using SolidLoad<Dim>::body_;

    /// Another liquid that this one sees.
    struct Neighbor {
        const Relation<Dim>* relation;
        const FluidStep* step;
        Interface interface;
        std::uint64_t builds = 0;  ///< of the list, when `facing` was found
        AlignedVector<Vec<Dim>> facing = {};
    };
    /// Across the interface with another liquid, of each particle.
    void findFacings();
    const AlignedVector<Vec<Dim>>& facing(const FluidStep& other) const;

    /// FluidSide::least_pull
    double leastPull() const {
        return liquids_.empty() ? 0 : -std::numeric_limits<double>::infinity();
    }
    /// What the momentum sum has read.
    bool isReadLater() const { return loads_solids_ || !liquids_.empty(); }
    template <class Real>
    void predict(double dt);
    /// Anew, where velocities have changed since the first half.
    template <class Real>
    void recordVelocities();
    template <class Real>
    void record(const Group& group, const VecOf<Dim, Wide>& v, Wide p, Wide V);
    template <class Real>
    void recordKicked(const Group& group, const VecOf<Dim, Wide>& v);
    /// The mean weight of the fluid in the frame of its walls, and its mean velocity.
    void findMeans();
    /// Gives back what elastic solids have lost by the impedance of the fluid (Radiation).
    template <class Real>
    void addSlipImpulses();
    /// That impulse on particle i from one of them.
    Vec<Dim> slipImpulse(const WallFields<Dim>& fields, const NeighborList<Dim>& list,
                         std::size_t i) const;
    template <Riemann R>
    Load<Dim> loadOn(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const;
    /// Of the sums over each wall, in the unit of its list.
    std::vector<SumGrid> wallGrids(double largest) const;
    template <Riemann R>
    void addLiquidForce(const Neighbor& liquid, Index i, std::array<double, Dim>& force) const;
    double liquidClosing(const Neighbor& liquid, Index i) const;
    template <Riemann R>
    void addWallForce(const typename Surroundings<Dim>::Wall& wall, const SumGrid& grid, Index i,
                      std::array<double, Dim>& force) const;
    double wallClosing(const typename Surroundings<Dim>::Wall& wall, const SumGrid& grid,
                       Index i) const;
    template <Riemann R, class Real>
    void momentum(double dt);
    template <Riemann R, class Real>
    void continuity(double dt);

    const Domain<Dim>* domain_;
    const materials::Fluid* fluid_;
    Riemann riemann_;
    RiemannConstants constants_;
    double largest_force_;  // that sums over pairs may reach, and of the rate
    double largest_rate_;
    double largest_impedance_;
    double cell_;         // volume of a particle of the lattice
    bool loads_solids_;   // that answer to forces
    double last_dt_ = 0;  // of the last slips
    // Found in the first step of each interval: no state of a restart.
    Vec<Dim> weight_ = Vec<Dim>::Zero();         // per volume
    Vec<Dim> mean_velocity_ = Vec<Dim>::Zero();  // in records it is taken off, which saves digits
    double interval_start_ = nan_value;
    std::uint64_t kicks_ = 0;           // FluidRole::kicks of the velocities in records
    mutable Surroundings<Dim> around_;  // looks at walls anew for a load
    std::vector<Neighbor> liquids_;

    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Field<double>& volume_;
    Field<double>& density_;
    Field<double>& density_rate_;
    Field<double>& slack_;
    Field<double>& pressure_;

    // Filled anew in every step, in which no particle comes, goes or moves in memory.
    // As the momentum sum reads it, then with the new velocity and the pressure above the
    // hydrostatic, as the continuity sum does. Velocities in units of c0, pressures in rho0 c0^2,
    // volumes in those of a cell of the lattice.
    TileRecords<Dim> records_;
    TileSums<Dim, Dim> forces_;
    TileSums<Dim, 1> rates_;
    // What the momentum sum has read, for other liquids, which meet it at the same instant, and for
    // solids that get what the fluid has felt.
    AlignedVector<PairState<Dim>> before_;
};

extern template class FluidStep<2>;
extern template class FluidStep<3>;

}  // namespace sphinx::dynamics::fluid
