// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/viscous_force.h"

#include "core/exact_sum.h"
#include "core/parallel.h"
#include "dynamics/pair_loop.h"

namespace sphinx::fluid {
namespace {

/// Adds the terms of eight pairs without factors, in the list's gradient unit, with g = e W',
/// W' = -abs(W') and V = V_i V_j:
///   laplacian   v_ij W'/r V
///   central     (v_ij . e) e W'/r V = (v_ij . g) g / (W' r) V
template <ViscousForm F, int Dim>
inline void addPairs(const Pairs<Dim>& pair, const Lanes v[Dim], Lanes r, Lanes V,
                     ExactSums<Dim>& sum) {
    const Lanes V_over_r = V / maxLanes(r, lanes(1e-30));
    if constexpr (F == ViscousForm::laplacian) {
        const Lanes f = -pair.dW * V_over_r;
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, v[c]);
    } else {
        Lanes along = {};
        for (int c = 0; c < Dim; ++c) along += v[c] * pair.gradient[c];
        const Lanes f = -along * pair.inverse_dW * V_over_r;
        for (int c = 0; c < Dim; ++c) sum[c].addProduct(f, pair.gradient[c]);
    }
}

/// By how much the velocity difference of place k grows where it is continued into the wall: from
/// the fluid particle's distance to the surface to that plus the depth of the wall particle.
/// `nearest`: least distance of a fluid particle from the wall that is told apart.
template <int Dim>
inline double continuation(const Pairs<Dim>& pair, int k, double distance, const Vec<Dim>& n,
                           double depth, double nearest) {
    double apart = 0;  // of the two particles, across the wall's surface
    for (int c = 0; c < Dim; ++c) apart -= n[c] * pair.gradient[c][k];
    apart = std::abs(apart) * pair.inverse_dW[k] * distance;
    return 1 + depth / std::max(apart - depth, nearest);
}

/// The same over the wall particles near the fluid particle i, with the velocity continued into
/// the wall; in the given gradient unit.
template <ViscousForm F, int Dim, class Wall>
inline void addWall(const Wall& wall, const NeighborList<Dim>& list, std::size_t i,
                    const Vec<Dim>& v, double V, double unit, double nearest, ExactSums<Dim>& sum) {
    V *= list.gradient_unit / unit;
    Distances<Dim> distances(list, i);
    forEachPair(list, i, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        double between[Dim][lane_count];
        for (int k = 0; k < lane_count; ++k) {
            const Index j = pair.index[k];
            const Vec<Dim>& vw = (*wall.velocity)[j];
            const Vec<Dim>& n = (*wall.normal)[j];
            const double continued = continuation<Dim>(pair, k, r[k], n, (*wall.depth)[j], nearest);
            for (int c = 0; c < Dim; ++c) between[c][k] = continued * (v[c] - vw[c]);
        }
        Lanes v_ij[Dim];
        for (int c = 0; c < Dim; ++c) v_ij[c] = loadLanes(between[c]);
        addPairs<F, Dim>(pair, v_ij, r, V * gatherLanes(wall.volume->data(), pair.index), sum);
    });
}

/// The same for one wall particle j over the fluid particles near it.
template <ViscousForm F, int Dim, class Wall>
inline void addFluid(const Wall& wall, const NeighborList<Dim>& list, std::size_t j,
                     const Field<Vec<Dim>>& velocity, const Field<double>& volume, double nearest,
                     ExactSums<Dim>& sum) {
    Distances<Dim> distances(list, j);
    const double V = (*wall.volume)[j];
    const Vec<Dim> vw = (*wall.velocity)[j];
    const Vec<Dim> n = (*wall.normal)[j];
    const double depth = (*wall.depth)[j];
    forEachPair(list, j, [&](const Pairs<Dim>& pair) {
        const Lanes r = distances.next();
        double between[Dim][lane_count];
        for (int k = 0; k < lane_count; ++k) {
            const Vec<Dim>& v = velocity[pair.index[k]];
            const double continued = continuation<Dim>(pair, k, r[k], n, depth, nearest);
            for (int c = 0; c < Dim; ++c) between[c][k] = continued * (vw[c] - v[c]);
        }
        Lanes v_ji[Dim];
        for (int c = 0; c < Dim; ++c) v_ji[c] = loadLanes(between[c]);
        addPairs<F, Dim>(pair, v_ji, r, V * gatherLanes(volume.data(), pair.index), sum);
    });
}

}  // namespace

template <int Dim>
ViscousForce<Dim>::ViscousForce(Context<Dim>& context, Body<Dim>& body, WallSlip slip,
                                ViscousForm form)
    : body_(&body),
      mu_(dynamic_cast<const WeaklyCompressibleFluid&>(*body.material).viscosity()),
      nearest_(0.25 * body.spacing),
      form_(form),
      // Weakly compressible: speeds stay below a tenth of that of sound. sum_j abs(W')/r V_j is a
      // few 1/spacing^2.
      largest_(dynamic_cast<const WeaklyCompressibleFluid&>(*body.material).soundSpeed() *
               std::pow(body.spacing, Dim - 2)),
      velocity_(body.particles.vector(fields::velocity)),
      external_(body.particles.vector(fields::external_acceleration)),
      mass_(body.particles.scalar(fields::mass)),
      volume_(body.particles.scalar(fields::volume)) {
    context.loads.push_back(this);
    for (Body<Dim>* other : body.sees) {
        if (other != &body && slip == WallSlip::free_slip) continue;
        Relation<Dim>& relation = context.relations.relation(body, *other);
        relation.list.keep_distance = true;
        if (other == &body) {
            self_ = &relation;
        } else {
            const WallFields<Dim> seen(*other);
            walls_.push_back({&relation, seen.velocity, seen.normal,
                              &other->particles.scalar(fields::depth), seen.volume});
        }
    }
}

template <int Dim>
template <ViscousForm F>
double ViscousForce<Dim>::factor() const {
    if constexpr (F == ViscousForm::laplacian) return 2 * mu_ * body_->kernel.laplacianFactor();
    return 2 * (Dim + 2) * mu_;
}

template <int Dim>
void ViscousForce<Dim>::run(const Clock& clock) {
    this->actedAt(clock.time);
    if (form_ == ViscousForm::laplacian)
        accelerate<ViscousForm::laplacian>();
    else
        accelerate<ViscousForm::central>();
}

template <int Dim>
template <ViscousForm F>
void ViscousForce<Dim>::accelerate() {
    const double unit = self_->list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    parallelRanges(body_->size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec<Dim> v = velocity_[i];
            ExactSums<Dim> sum(grid);
            Distances<Dim> distances(self_->list, i);
            forEachPair(self_->list, i, [&](const Pairs<Dim>& pair) {
                const Lanes r = distances.next();
                double between[Dim][lane_count];
                for (int k = 0; k < lane_count; ++k) {
                    const Vec<Dim>& vj = velocity_[pair.index[k]];
                    for (int c = 0; c < Dim; ++c) between[c][k] = v[c] - vj[c];
                }
                Lanes v_ij[Dim];
                for (int c = 0; c < Dim; ++c) v_ij[c] = loadLanes(between[c]);
                addPairs<F, Dim>(pair, v_ij, r,
                                 volume_[i] * gatherLanes(volume_.data(), pair.index), sum);
            });
            for (const Wall& wall : walls_)
                addWall<F, Dim>(wall, wall.relation->list, i, v, volume_[i], unit, nearest_, sum);
            const double scale = unit * factor<F>() / mass_[i];
            for (int c = 0; c < Dim; ++c) external_[i][c] += scale * sum[c].value();
        }
    });
}

template <int Dim>
Vec<Dim> ViscousForce<Dim>::forceOn(const Body<Dim>& solid, const NeighborList<Dim>& list) const {
    for (const Wall& wall : walls_)
        if (wall.relation->to == &solid)
            return form_ == ViscousForm::laplacian ? forceOn<ViscousForm::laplacian>(wall, list)
                                                   : forceOn<ViscousForm::central>(wall, list);
    return Vec<Dim>::Zero();
}

template <int Dim>
template <ViscousForm F>
Vec<Dim> ViscousForce<Dim>::forceOn(const Wall& wall, const NeighborList<Dim>& list) const {
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    return parallelReduce(
        body_->size(), Vec<Dim>(Vec<Dim>::Zero()),
        [&](std::size_t begin, std::size_t end) {
            Vec<Dim> part = Vec<Dim>::Zero();
            for (std::size_t i = begin; i < end; ++i) {
                if (list.ranges[i].count == 0) continue;
                ExactSums<Dim> sum(grid);
                addWall<F, Dim>(wall, list, i, velocity_[i], volume_[i], unit, nearest_, sum);
                for (int c = 0; c < Dim; ++c) part[c] -= unit * factor<F>() * sum[c].value();
            }
            return part;
        },
        [](const Vec<Dim>& a, const Vec<Dim>& b) -> Vec<Dim> { return a + b; });
}

template <int Dim>
void ViscousForce<Dim>::addForces(const Body<Dim>& solid, const NeighborList<Dim>& list,
                                  Field<Vec<Dim>>& force) const {
    for (const Wall& wall : walls_) {
        if (wall.relation->to != &solid) continue;
        if (form_ == ViscousForm::laplacian)
            addForces<ViscousForm::laplacian>(wall, list, force);
        else
            addForces<ViscousForm::central>(wall, list, force);
    }
}

template <int Dim>
template <ViscousForm F>
void ViscousForce<Dim>::addForces(const Wall& wall, const NeighborList<Dim>& list,
                                  Field<Vec<Dim>>& force) const {
    const double unit = list.gradient_unit;
    const SumGrid grid(largest_ / unit);
    parallelFor(list.ranges.size(), [&](std::size_t j) {
        if (list.ranges[j].count == 0) return;
        ExactSums<Dim> sum(grid);
        addFluid<F, Dim>(wall, list, j, velocity_, volume_, nearest_, sum);
        for (int c = 0; c < Dim; ++c) force[j][c] += unit * factor<F>() * sum[c].value();
    });
}

void declareViscousForce(input::Registry& registry) {
    using P = ViscousForceParameters;
    auto& d = declareMethod<P>(registry, "fluid.viscous_force",
                               []<int Dim>(const P& p, Context<Dim>& context) {
                                   return std::make_unique<ViscousForce<Dim>>(
                                       context, bodyOf(context, p.body), p.wall, p.form);
                               });
    d.summary("Viscous force between fluid particles and from no-slip walls");
    d.formula(
        "laplacian: dv_i/dt = 2 mu L/m_i sum_j v_ij/r_ij W' V_i V_j; central, guide (35): "
        "dv_i/dt = 2 (d+2) mu/m_i sum_j (v_ij . e_ij)/r_ij e_ij W' V_i V_j");
    d.citation(
        "Morris, Fox & Zhu 1997, doi:10.1006/jcph.1997.5776 (laplacian; velocity inside walls)");
    d.required("body", &P::body, input::bodyReference({"fluid"}),
               "fluid; its material gives the viscosity");
    d.optional("wall", &P::wall,
               input::choice<WallSlip>({
                   {"no_slip", WallSlip::no_slip, "the fluid sticks to solids"},
                   {"free_slip", WallSlip::free_slip, "solids exert no viscous force"},
               }),
               "condition at solids");
    d.optional("form", &P::form,
               input::choice<ViscousForm>({
                   {"laplacian", ViscousForm::laplacian, "exact in shear flow along walls"},
                   {"central", ViscousForm::central,
                    "guide (35): conserves angular momentum, for free fluid that turns; up to 18 % "
                    "too weak in shear flow along walls"},
               }),
               "sum over pairs");
    d.trait("sums_over_itself");
    d.action()
        .reads("body", {"velocity", "mass", "volume", "neighbors"})
        .reads("neighbors.solid", {"normal", "depth", "volume"})
        .reads("neighbors.rigid", {"velocity"})
        .reads("neighbors.elastic", {"average_velocity"})
        .writes("body", {"fresh_viscous_load"})
        .accumulates("body", {"external_acceleration"});
}

template class ViscousForce<2>;
template class ViscousForce<3>;

}  // namespace sphinx::fluid
