// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/builder.h"
#include "dynamics/fluid/solid_load.h"
#include "materials/fluid.h"

namespace sphinx::fluid {

enum class WallSlip { no_slip, free_slip };

struct ViscousForceParameters {
    input::Name body;
    WallSlip wall = WallSlip::no_slip;
};

/// Viscous force, guide (35) with the case's own dimension d:
///   dv_i/dt = 2 (d + 2) mu / m_i sum_j (v_ij . e_ij) / r_ij  e_ij W' V_i V_j
/// It conserves linear and angular momentum. At a no-slip wall the velocity is continued linearly
/// through the wall's surface: v_ij = (v_i - v_w) (1 + d_j/d_i) with the distances of both particles
/// from the surface; Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776, (31)-(32).
template <int Dim>
class ViscousForce final : public Method, public SolidLoad<Dim> {
   public:
    ViscousForce(Context<Dim>& context, Body<Dim>& body, WallSlip slip);

    void run(int action, const Clock& clock) override;
    std::size_t workSize() const override { return body_->size(); }

    LoadKind loadKind() const override { return LoadKind::viscous; }
    Body<Dim>& fluid() const override { return *body_; }
    Vec<Dim> forceOn(const Body<Dim>& solid, const NeighborList<Dim>& list) const override;

   private:
    struct Wall {
        const Relation<Dim>* relation;
        const Field<Vec<Dim>>* velocity;
        const Field<Vec<Dim>>* normal;
        const Field<double>* depth;
        const Field<double>* volume;
    };

    Body<Dim>* body_;
    double mu_;
    double nearest_;  // least distance of a fluid particle from a wall that is told apart
    const Relation<Dim>* self_ = nullptr;
    std::vector<Wall> walls_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Field<double>& volume_;
};

/// Registers fluid.viscous_force.
void declareViscousForce(input::Registry& registry);

extern template class ViscousForce<2>;
extern template class ViscousForce<3>;

}  // namespace sphinx::fluid
