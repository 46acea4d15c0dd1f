// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/viscous_load.h"

#include "core/sum_all.h"
#include "dynamics/pair_loop.h"

#include <cmath>

namespace sphinx::dynamics::fluid {

template <int Dim>
ViscousLoad<Dim>::ViscousLoad(Context<Dim>& context, const ViscousForceParameters& p)
    : SolidLoad<Dim>(context, bodyOf(context, p.body), LoadKind::viscous),
      nearest_(nearest_to_wall * body_->spacing),
      form_(p.form),
      cell_(std::pow(body_->spacing, Dim)),
      per_viscosity_(
          2 * (p.form == ViscousForm::laplacian ? body_->kernel.laplacianFactor() : Dim + 2)),
      // What makes the sums forces.
      factor_(body_->fluid().material->viscosity() * per_viscosity_),
      largest_(largestViscousSum(*body_)),
      around_(context, *body_,
              {.walls = {.distance = true},
               .liquids = {.distance = true},
               .sees_walls = p.wall == WallSlip::no_slip}),
      velocity_(body_->particles.vector(fields::velocity)),
      mass_(body_->particles.scalar(fields::mass)),
      volume_(body_->particles.scalar(fields::volume)) {
    if (const auto* law = materials::asGeneralisedNewtonian(*body_->fluid().material))
        varying_.emplace(
            Varying{law, VelocityGradient<Dim>(context, *body_, p.wall == WallSlip::no_slip),
                    StressDivergence<Dim>(), body_->particles.scalar(fields::viscosity),
                    body_->particles.scalar(fields::shear_rate), law->viscosity()});
}

template <int Dim>
std::vector<const Body<Dim>*> ViscousLoad<Dim>::wallBodies() const {
    std::vector<const Body<Dim>*> bodies;
    for (const auto& wall : around_.walls()) bodies.push_back(wall.body);
    return bodies;
}

template <int Dim>
void ViscousLoad<Dim>::findSlopes() const {
    Varying& v = *varying_;
    if (around_.walls().empty()) return;
    const double largest = maxAll(body_->size(), 0.0, [&](std::size_t i) { return 1 / share(i); });
    v.gradients.begin(around_.own(), body_->size(), volume_, cell_);
    v.slope = v.gradients.find(largest, [&](Index i) { return 1 / share(i); });
    v.version = body_->version;
}

template <int Dim>
Load<Dim> ViscousLoad<Dim>::loadOn(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                   const Vec<Dim>& about) const {
    const auto* wall = around_.wall(solid);
    if (!wall) return {};
    if (varying_) {
        if (!(maxAll(body_->size(), 0.0, [&](std::size_t i) { return share(i); }) > 0)) return {};
        if (varying_->version != body_->version || varying_->slope.size() != body_->size())
            findSlopes();
    }
    return withForm(form_, [&]<ViscousForm F>() { return loadOn<F>(*wall, list, about); });
}

template <int Dim>
template <ViscousForm F>
Load<Dim> ViscousLoad<Dim>::loadOn(const typename Surroundings<Dim>::Wall& wall,
                                   const NeighborList<Dim>& list, const Vec<Dim>& about) const {
    using Vector = VecOf<Dim, Wide>;
    constexpr int moments = Dim == 2 ? 1 : 3;
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    const SumGrid moment_grid(largest_ * list.cutoff / unit);
    const auto& position = body_->particles.position();
    return sumAll(body_->size(), [&](std::size_t i) {
        Load<Dim> own;
        if (list.ranges[i].count == 0) return own;
        ExactSums<Dim> sum(grid);
        // The forces act at the wall's particles, r_ij away: -sum_j r_ij x f_ij.
        ExactSums<moments> lever(moment_grid);
        forEachWallPair<Dim>(
            wall.fields, list, i, felt()[i], nearest_,
            [&](const Pairs<Dim>& pair, const Lanes(&v_ij)[Dim], Lanes r, Lanes V_j) {
                Lanes V = volume_[i] * V_j;
                if (varying_) V *= shareAtWall(pair, r, i);
                const Lanes f = viscousFactor<F, Dim, Lanes>(pair, v_ij, r, V);
                const auto& direction = viscousDirection<F, Dim, Lanes>(pair, v_ij);
                Vector d, e;
                for (int c = 0; c < Dim; ++c) {
                    sum[c].addProduct(f, direction[c]);
                    d[c] = direction[c];
                    e[c] = -pair.gradient[c] * pair.inverse_dW;
                }
                const auto turned = momentOf<Dim, Wide>(e, d);
                for (int c = 0; c < moments; ++c) lever[c].addProduct(f * r, turned[c].at);
            });
        const double scale = -unit * factor_;
        Vec<Dim> force;
        for (int c = 0; c < Dim; ++c) force[c] = scale * sum[c].value();
        own.add(position[i] - about, force);
        for (int c = 0; c < moments; ++c) own.moment[c] -= scale * lever[c].value();
        return own;
    });
}

template <int Dim>
void ViscousLoad<Dim>::addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                 Field<Vec<Dim>>& force) const {
    if (const auto* wall = around_.wall(solid))
        withForm(form_, [&]<ViscousForm F>() { addForces<F>(*wall, list, force); });
}

template <int Dim>
template <ViscousForm F>
void ViscousLoad<Dim>::addForces(const typename Surroundings<Dim>::Wall& wall,
                                 const NeighborList<Dim>& list, Field<Vec<Dim>>& force) const {
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    parallelFor(list.ranges.size(), [&](std::size_t j) {
        if (list.ranges[j].count == 0) return;
        ExactSums<Dim> sum(grid);
        const double V = (*wall.fields.volume)[j];
        forEachFluidPair<Dim>(
            wall.fields, list, j, felt(), volume_, nearest_,
            [&](const Pairs<Dim>& pair, const Lanes(&v_ji)[Dim], Lanes r, Lanes V_i) {
                Lanes weight = V * V_i;
                if (varying_) {
                    Lanes slope[Dim];
                    gatherVectors<Dim>(varying_->slope.data(), pair.index, slope);
                    weight *= shareAtWall(
                        Pairs<Dim>{pair.reversed(), pair.index}, r,
                        varying_->largest / gatherLanes(varying_->viscosity.data(), pair.index),
                        slope);
                }
                addPairs<F, Dim>(pair, v_ji, r, weight, sum);
            });
        for (int c = 0; c < Dim; ++c) force[j][c] += unit * factor_ * sum[c].value();
    });
}

template class ViscousLoad<2>;
template class ViscousLoad<3>;

}  // namespace sphinx::dynamics::fluid
