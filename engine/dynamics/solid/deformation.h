// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "dynamics/arrangement_watch.h"
#include "dynamics/context.h"
#include "dynamics/group.h"
#include "dynamics/solid/reference_loop.h"
#include "dynamics/solid/still_groups.h"
#include "materials/elastic_solid.h"

#include <vector>

namespace sphinx::dynamics::solid {

/// Deformation and stress of an elastic body whose neighbors are those of the reference
/// configuration: in itself and in the bodies bonded to it. Gradients g_ij = e_ij W'_ij V_j.
template <int Dim>
class Deformation {
 public:
    /// With hourglass control also the energy 1/2 c sum_j k_ij abs(r_ij - F_i R_ij)^2 per volume of
    /// what F_i does not see of its neighbors' motion, k_ij = abs(W'_ij)/R_ij V_j, c = mu. F_i is
    /// the very F that minimises it, so its force is that of springs between pairs, -c k_ij (2 r_ij
    /// - (F_i + F_j) R_ij), and comes from an energy that no rotation changes. As sum_j k_ij R_ij
    /// (x) R_ij = I inside of a body, the shear energy mu/2 tr F^T F of a neo-Hookean law is then
    /// the springs' alone, and F_i is left with the change of volume: the pair-wise shear of Wu,
    /// Zhang, Tang & Hu 2024, doi:10.1016/j.jcp.2024.113072, here with an energy, for any law, and
    /// without a factor to fit. Where a clamp covers a part of a particle, all of its energy counts
    /// by its share s_i (ElasticRole::shares). For initialize() alone it does not matter.
    ///
    /// Without it a particle sees its neighbors only through F, and rows of particles decouple.
    /// Errors with it, also for other c: README.md.
    Deformation(Context<Dim>& context, Body<Dim>& body, bool hourglass_control);

    Body<Dim>& body() const { return *body_; }

    /// Tells the body its hourglass modulus.
    void announce();
    /// Builds the lists where particles have other places than they name.
    void prepare();
    /// B_i = (-sum_j R_ij (x) g_ij)^-1, guide (30); F from the positions, (29), and dF/dt from the
    /// velocities. PhysicsError where a particle has too few neighbors.
    void initialize();
    /// F += dt/2 dF/dt; then the stress P = F S of the law and of the damping (16), kept as
    /// T = s (P B^T - c F), and, where s is not 0, the density rho0 / det F, (4). PhysicsError
    /// where det F is not above 0 or the law has no stress. `damping`: whether that of the material
    /// acts.
    void firstHalf(const Clock& clock, bool damping = true);
    /// dF/dt = (-sum_j v_ij (x) g_ij) B_i, then F += dt/2 dF/dt.
    void secondHalf(double dt);
    /// sum_j (T_i + T_j) g_ij = div P at the particles of a group, force/volume; guide (31) in the
    /// form that is conjugate to (29). With hourglass control, its force as well. Once for each
    /// group after firstHalf().
    VecOf<Dim, Wide> stressDivergence(const Group& group) {
        return still_.sumOf(group, [&] { return sumOfStresses(group); });
    }

 private:
    struct Neighbors {
        ReferenceRelation<Dim>* relation;
        const Field<Vec<Dim>>* position;
        const Field<Vec<Dim>>* initial_position;
        const Field<Vec<Dim>>* velocity;
        const Field<Mat<Dim>>* stress;
        ArrangementWatch watch;  // of the particles that the list names
    };
    using NeighborField = const Field<Vec<Dim>>* Neighbors::*;
    /// -sum_j (a_i - a_j) (x) g_ij
    MatOf<Dim, Wide> difference(const Group& group, const Field<Vec<Dim>>& own,
                                NeighborField values) const;
    [[gnu::flatten]] VecOf<Dim, Wide> sumOfStresses(const Group& group) const;
    /// Before both halves.
    void prepareSums();
    template <class Law>
    void stress(const Law& law, const Clock& clock, bool damping);
    [[noreturn]] void fail(std::size_t i, const std::string& what, const Clock& clock) const;

    Context<Dim>* context_;
    Body<Dim>* body_;
    bool hourglass_control_;
    const materials::ElasticSolid* solid_;
    std::vector<Neighbors> neighbors_;

    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& initial_position_;
    Field<Vec<Dim>>& velocity_;
    Field<double>& density_;
    Field<Mat<Dim>>& correction_;
    Field<Mat<Dim>>& gradient_;
    Field<Mat<Dim>>& rate_;
    Field<Mat<Dim>>& stress_;
    Planes<Dim> stress_planes_;  // the same
    StillGroups<Dim> still_;
};

}  // namespace sphinx::dynamics::solid
