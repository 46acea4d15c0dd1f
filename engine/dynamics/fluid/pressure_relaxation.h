// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"
#include "dynamics/fluid/pair_state.h"
#include "dynamics/fluid/solid_load.h"
#include "dynamics/fluid/surroundings.h"
#include "dynamics/fluid/terms/riemann.h"
#include "materials/fluid.h"

namespace sphinx::dynamics::fluid {

struct PressureRelaxationParameters {
    input::Name body;
    Riemann riemann = Riemann::low_dissipation;
};

/// Acoustic step of a weakly compressible fluid, guide (51) and (56)-(58) read as drift-kick-drift:
///   first half:  rho += dt/2 drho, p(rho), r += dt/2 v, then
///                dv_i = -1/m_i sum_j 2 p*_ij e_ij W' V_i V_j + external,  v += dt dv
///   second half: drho_i = rho_i sum_j 2 (v_i - v*_ij) . e_ij W' V_j,  rho += dt/2 drho, r += dt/2
///   v
/// with p* and v* of the Riemann problem (riemann.h). Each sum runs once a step, and a solid loaded
/// between the halves feels the pressure that the fluid felt.
///
/// In gravity the pressures in U* are those above the hydrostatic one, p - rho0 g . r: a fluid at
/// rest is left at rest (Fourtakas et al. 2019, doi:10.1016/j.compfluid.2019.06.009, for the
/// equivalent density diffusion). With p itself the solver takes the weight of the fluid for a
/// jump: the pressure of water at rest is then too high by that of half a spacing at the surface.
/// (That it is not 1.5 % too high everywhere: Kernel::gradientFactor.)
///
/// Solid neighbors are walls of dummy particles, one-sided Riemann problem along the wall's normal
/// n (turned towards the fluid): the ghost has the mirrored normal velocity (free slip) and the
/// pressure p_i + rho_i r_ij max(0, -(g_i - a_w) . e_ij).
template <int Dim>
class PressureRelaxation final : public Method, public SolidLoad<Dim> {
 public:
    PressureRelaxation(Context<Dim>& context, Body<Dim>& body, Riemann riemann);

    std::size_t workSize() const override { return body_->size(); }

    LoadKind loadKind() const override { return LoadKind::pressure; }
    Body<Dim>& fluid() const override { return *body_; }
    void rest() override { this->endLoad(); }
    void transfer(Archive& archive) override { this->transferLoad(archive); }
    Load<Dim> loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const override;
    void addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                   Field<Vec<Dim>>& force) const override;

    void firstHalf(const Clock& clock);
    void secondHalf(const Clock& clock);

 private:
    void predict(double dt);
    template <Riemann R>
    Load<Dim> loadOn(const typename Surroundings<Dim>::Wall& wall, const NeighborList<Dim>& list,
                     const Vec<Dim>& about) const;
    template <Riemann R>
    void momentum(double dt);
    template <Riemann R>
    void continuity(double dt);

    Body<Dim>* body_;
    const Domain<Dim>* domain_;
    const materials::Fluid* fluid_;
    Riemann riemann_;
    RiemannConstants constants_;
    double largest_force_;  // that sums over pairs may reach, and of the rate
    double largest_rate_;
    Surroundings<Dim> around_;

    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Field<double>& volume_;
    Field<double>& density_;
    Field<double>& density_rate_;
    Field<double>& pressure_;

    // Filled anew in every step, in which no particle comes, goes or moves in memory.
    AlignedVector<PairState<Dim>> before_;  // packed at the half step, read by the momentum sum
    // With the new velocity and the pressure above the hydrostatic, read by the continuity sum.
    AlignedVector<PairState<Dim>> after_;
};

/// Registers fluid.pressure_relaxation.
void declarePressureRelaxation(input::Registry& registry);

}  // namespace sphinx::dynamics::fluid
