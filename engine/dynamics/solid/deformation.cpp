// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// The compiler may fuse products and sums here, and the bits depend on it: engine/CMakeLists.txt.
#ifndef SPHINX_FUSED
#error "compile this file with -ffp-contract=fast and SPHINX_FUSED"
#endif

#include "dynamics/solid/deformation.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "core/place_text.h"
#include "dynamics/solid/fibres.h"
#include "materials/elastic_laws.h"
#include "materials/strain.h"

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>

namespace sphinx::dynamics::solid {
namespace {

/// Places of the particles at which a loop failed: the first of them, for any number of threads.
class FirstFailure {
 public:
    void at(std::size_t i) {
        std::size_t known = first_.load();
        while (i < known && !first_.compare_exchange_weak(known, i)) {
        }
    }
    bool found() const { return first_.load() != none; }
    std::size_t first() const { return first_.load(); }

 private:
    static constexpr std::size_t none = ~std::size_t{0};
    std::atomic<std::size_t> first_ = none;
};

Wide determinant(const MatOf<2, Wide>& a) { return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0); }
Wide determinant(const MatOf<3, Wide>& a) { return a.col(0).dot(a.col(1).cross(a.col(2))); }

}  // namespace

template <int Dim>
Deformation<Dim>::Deformation(Context<Dim>& context, Body<Dim>& body, bool hourglass_control)
    : context_(&context),
      body_(&body),
      hourglass_control_(hourglass_control),
      solid_(body.elastic().material.get()),
      position_(body.particles.position()),
      initial_position_(body.particles.vector(fields::initial_position)),
      velocity_(body.particles.vector(fields::velocity)),
      density_(body.particles.scalar(fields::density)),
      correction_(body.particles.matrix(fields::correction_matrix)),
      gradient_(body.particles.matrix(fields::deformation_gradient)),
      rate_(body.particles.matrix(fields::deformation_rate)),
      stress_(body.particles.matrix(fields::corrected_stress)) {
    for (Body<Dim>* other : body.piece()) {
        ParticleSet<Dim>& p = other->particles;
        neighbors_.push_back({&context.relations.reference(body, *other),
                              &p.position(),
                              &p.vector(fields::initial_position),
                              &p.vector(fields::velocity),
                              &p.matrix(fields::corrected_stress),
                              {}});
    }
}

template <int Dim>
void Deformation<Dim>::announce() {
    body_->elastic().hourglass_modulus = hourglass_control_ ? solid_->shearModulus() : 0;
}

template <int Dim>
void Deformation<Dim>::prepare() {
    for (const Neighbors& n : neighbors_) context_->relations.build(*n.relation);
}

template <int Dim>
void Deformation<Dim>::prepareSums() {
    prepare();
    bool changed = false;
    for (Neighbors& n : neighbors_) changed |= n.watch.hasChanged(n.relation->to->particles);
    if (!changed) return;
    const std::size_t particles = body_->size();
    still_.begin(particles);
    for (const Neighbors& n : neighbors_) {
        const auto& list = n.relation->list;
        if (n.relation->to == body_)
            still_.setNeighbors(list, particles);
        else
            still_.excludeNeighborsOf(list);
    }
}

template <int Dim>
MatOf<Dim, Wide> Deformation<Dim>::difference(const Group& group, const Field<Vec<Dim>>& own,
                                              NeighborField values) const {
    MatOf<Dim, Wide> sum = MatOf<Dim, Wide>::Zero();
    const VecOf<Dim, Wide> a = load(own, group);
    for (const Neighbors& n : neighbors_)
        sum += differenceSum<Dim>(n.relation->list, group, a, *(n.*values));
    return sum;
}

template <int Dim>
void Deformation<Dim>::initialize() {
    prepare();
    FirstFailure lonely;
    parallelForGroups(body_->size(), [&](const Group& group) {
        const auto moments = difference(group, initial_position_, &Neighbors::initial_position);
        const auto places = difference(group, position_, &Neighbors::position);
        const auto velocities = difference(group, velocity_, &Neighbors::velocity);
        for (std::size_t k = 0; k < group.count; ++k) {
            const std::size_t i = group.first + k;
            const Mat<Dim> moment = lane(moments, k);
            // 1 inside of a body, about a half at its surface; 0 for particles in a row or alone.
            if (!(std::abs(moment.determinant()) > 1e-3)) {
                lonely.at(i);
                continue;
            }
            correction_[i] = moment.inverse();
            gradient_[i] = lane(places, k) * correction_[i];
            rate_[i] = lane(velocities, k) * correction_[i];
        }
    });
    if (lonely.found())
        fail(lonely.first(),
             "has too few neighbors to tell how it deforms: a body needs two "
             "particles or more across in every direction",
             {});
}

template <int Dim>
template <class Law>
void Deformation<Dim>::stress(const Law& law, const Clock& clock, bool damping) {
    const double half = 0.5 * clock.dt;
    const bodies::ElasticRole<Dim>& role = body_->elastic();
    const double eta = damping ? solid_->damping() : 0;
    const double control = role.hourglass_modulus;
    const double rho0 = solid_->density();
    const ParticleFibres<Dim> fibres(*body_, Law::uses_fibres);
    FirstFailure inverted;
    FirstFailure beyond;
    stress_planes_.resize(body_->size());
    parallelForGroups(body_->size(), [&](const Group& group) {
        using Matrix = MatOf<Dim, Wide>;
        addProduct(half, rate_, gradient_, group);
        const Matrix F = load(gradient_, group);
        const Wide J = determinant(F);
        const Matrix C = materials::rightCauchyGreen<Dim, Wide>(F);
        const unsigned sound = maskBits((J > 0) & law.template admissible<Dim, Wide>(C));
        for (std::size_t k = 0; sound != all_lanes && k < group.count; ++k) {
            const std::size_t i = group.first + k;
            if (sound >> k & 1 || role.share(i) == 0) continue;
            (J[k] > 0 ? beyond : inverted).at(i);
        }
        Matrix S = law.template stress<Dim, Wide>(C, fibres[group]);
        if (eta > 0) {
            const Matrix FtR = F.transpose() * load(rate_, group);
            S += (0.5 * eta) * (FtR + FtR.transpose());
        }
        // The control's - c k_ij (F_i + F_j) R_ij has the form of a stress, k_ij R_ij = -g_ij.
        const Matrix P = F * S;
        Matrix T = P * load(correction_, group).transpose();
        T -= control * F;
        Wide density = rho0 / J;
        if (!role.shares.empty()) {
            const Wide share = load(role.shares.data(), group);
            const LaneMask material = share != 0;
            for (Wide& t : T.reshaped()) t = select(material, share * t, 0);
            density = select(material, density, load(density_, group));
        }
        still_.look(velocity_, position_, T, stress_planes_, group);
        store(T, stress_, group);
        stress_planes_.store(T, group);
        store(density, density_, group);
    });
    if (inverted.found()) {
        const double J = gradient_[inverted.first()].determinant();
        fail(inverted.first(),
             std::isfinite(J)
                 ? fmt::format("is inverted (det F = {:g}); a smaller cfl, a finer spacing or a "
                               "stiffer material may help",
                               J)
                 : "has a deformation gradient that is not a number; see the forces and motions "
                   "that act on it",
             clock);
    }
    if (beyond.found()) {
        const Mat<Dim>& F = gradient_[beyond.first()];
        const double strain = F.squaredNorm() - Dim;
        fail(beyond.first(),
             fmt::format("is stretched beyond the finite extensibility of its "
                         "material (I1 - 3 = {:g})",
                         strain),
             clock);
    }
}

template <int Dim>
void Deformation<Dim>::firstHalf(const Clock& clock, bool damping) {
    prepareSums();
    materials::withLaw(*solid_, [&](const auto& law) { stress(law, clock, damping); });
    for (const ContactStress<Dim>* contact : context_->contact_stresses) {
        if (contact->body != body_) continue;
        for (std::size_t n = 0; n < contact->particles.size(); ++n) {
            const Index i = contact->particles[n];
            stress_[i] += contact->stress[n] * correction_[i].transpose();
            stress_planes_.set(i, stress_[i]);
            still_.change(i / lane_count);
        }
    }
}

template <int Dim>
void Deformation<Dim>::secondHalf(double dt) {
    prepareSums();
    const double half = 0.5 * dt;
    parallelForGroups(body_->size(), [&](const Group& group) {
        if (still_.rests(velocity_, group)) {
            if (!isZero(rate_, group)) setZero(rate_, group);
            return;
        }
        const MatOf<Dim, Wide> rate =
            difference(group, velocity_, &Neighbors::velocity) * load(correction_, group);
        store(rate, rate_, group);
        addProduct(half, rate_, gradient_, group);
    });
}

template <int Dim>
VecOf<Dim, Wide> Deformation<Dim>::sumOfStresses(const Group& group) const {
    VecOf<Dim, Wide> sum = VecOf<Dim, Wide>::Zero();
    const MatOf<Dim, Wide> T = load(stress_, group);
    const VecOf<Dim, Wide> r = load(position_, group);
    for (const Neighbors& n : neighbors_) {
        const auto& list = n.relation->list;
        const double control =
            body_->elastic().hourglass_modulus + n.relation->to->elastic().hourglass_modulus;
        const auto of = [&](const auto& neighbors) { return load(*n.stress, neighbors); };
        if (n.stress != &stress_) {
            sum += forceSum<Dim>(list, group, T, of, control, r, *n.position);
            continue;
        }
        const auto of_own = [&](const auto& neighbors) {
            if constexpr (std::is_same_v<std::decay_t<decltype(neighbors)>, Run>)
                return stress_planes_.load(neighbors);
            else
                return of(neighbors);
        };
        sum += forceSum<Dim>(list, group, T, of_own, control, r, *n.position);
    }
    return sum;
}

template <int Dim>
void Deformation<Dim>::fail(std::size_t i, const std::string& what, const Clock& clock) const {
    const World<Dim>& world = context_->world;
    throw PhysicsError(fmt::format("particle {} of {} at {} {}, time {}", body_->particles.id()[i],
                                   body_->name, world.placeText(position_[i]), what,
                                   world.quantityText(clock.time, unit::time)));
}

template class Deformation<2>;
template class Deformation<3>;

}  // namespace sphinx::dynamics::solid
