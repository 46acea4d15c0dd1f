// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/deformation.h"

#include "core/errors.h"
#include "core/parallel.h"
#include "core/place_text.h"
#include "dynamics/solid/fibres.h"
#include "dynamics/solid/reference_loop.h"
#include "materials/elastic.h"
#include "materials/strain.h"

#include <fmt/format.h>
#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>

namespace sphinx::solid {
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

}  // namespace

template <int Dim>
Deformation<Dim>::Deformation(Context<Dim>& context, Body<Dim>& body, bool hourglass_control)
    : Deformation(context, body) {
    body.hourglass_modulus = hourglass_control ? solid_->shearModulus() / Dim : 0;
}

template <int Dim>
Deformation<Dim>::Deformation(Context<Dim>& context, Body<Dim>& body)
    : relations_(&context.relations),
      body_(&body),
      solid_(&dynamic_cast<const ElasticSolid&>(*body.material)),
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
        neighbors_.push_back({&context.relations.reference(body, *other), &p.position(),
                              &p.vector(fields::initial_position), &p.vector(fields::velocity),
                              &p.matrix(fields::corrected_stress)});
    }
}

template <int Dim>
void Deformation<Dim>::prepare() {
    if (prepared_) return;
    for (const Neighbors& n : neighbors_) relations_->build(*n.relation);
    prepared_ = true;
}

template <int Dim>
Mat<Dim> Deformation<Dim>::difference(std::size_t i, const Vec<Dim>& own,
                                      NeighborField values) const {
    Mat<Dim> result = Mat<Dim>::Zero();
    for (const Neighbors& n : neighbors_) {
        Lanes sum[Dim][Dim] = {};
        addOuter<Dim>(n.relation->list, i, (n.*values)->data(), sum);
        const Mat<Dim> total = sumMatrix<Dim>(sum);
        const Vec<Dim>& weight = n.relation->gradient_sum[i];
        for (int d = 0; d < Dim; ++d)
            for (int c = 0; c < Dim; ++c) result(c, d) += total(c, d) - own[c] * weight[d];
    }
    return result;
}

template <int Dim>
void Deformation<Dim>::initialize() {
    prepare();
    FirstFailure lonely;
    parallelFor(body_->size(), [&](std::size_t i) {
        const Mat<Dim> moment = difference(i, initial_position_[i], &Neighbors::initial_position);
        // 1 inside of a body, about a half at its surface; 0 for particles in a row or alone.
        if (!(std::abs(moment.determinant()) > 1e-3)) {
            lonely.at(i);
            return;
        }
        correction_[i] = moment.inverse();
        gradient_[i] = difference(i, position_[i], &Neighbors::position) * correction_[i];
        rate_[i] = difference(i, velocity_[i], &Neighbors::velocity) * correction_[i];
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
    const double eta = damping ? solid_->damping() : 0;
    const double control = body_->hourglass_modulus;
    const double rho0 = solid_->density();
    const ParticleFibres<Dim> fibres(*body_, Law::uses_fibres);
    FirstFailure inverted;
    FirstFailure beyond;
    parallelRanges(body_->size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Mat<Dim> rate = rate_[i];
            const Mat<Dim> F = gradient_[i] + half * rate;
            gradient_[i] = F;
            const double share = body_->share(i);
            if (share == 0) {
                stress_[i].setZero();
                continue;
            }
            const double J = F.determinant();
            if (!(J > 0)) {
                inverted.at(i);
                continue;
            }
            const Mat<Dim> C = rightCauchyGreen<Dim>(F);
            if (!law.template admissible<Dim>(C)) {
                beyond.at(i);
                continue;
            }
            Mat<Dim> S = law.template stress<Dim>(C, fibres[i]);
            if (eta > 0) {
                const Mat<Dim> FtR = F.transpose() * rate;
                S += (0.5 * eta) * (FtR + FtR.transpose());
            }
            // The control's - c k_ij (F_i + F_j) R_ij has the form of a stress, k_ij R_ij = -g_ij.
            const Mat<Dim> P = F * S;
            Mat<Dim> T = P * correction_[i].transpose();
            T -= control * F;
            stress_[i] = share * T;
            density_[i] = rho0 / J;
        }
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
    prepare();
    withLaw(*solid_, [&](const auto& law) { stress(law, clock, damping); });
}

template <int Dim>
void Deformation<Dim>::secondHalf(double dt) {
    const double half = 0.5 * dt;
    parallelFor(body_->size(), [&](std::size_t i) {
        const Mat<Dim> rate = difference(i, velocity_[i], &Neighbors::velocity) * correction_[i];
        rate_[i] = rate;
        gradient_[i] += half * rate;
    });
}

template <int Dim>
Vec<Dim> Deformation<Dim>::stressDivergence(std::size_t i) const {
    Vec<Dim> result = Vec<Dim>::Zero();
    for (const Neighbors& n : neighbors_) {
        Lanes sum[Dim] = {};
        addProduct<Dim>(n.relation->list, i, n.stress->data(), sum);
        result += stress_[i] * n.relation->gradient_sum[i];
        const double control = body_->hourglass_modulus + n.relation->to->hourglass_modulus;
        if (control > 0) {
            addWeighted<Dim>(n.relation->list, n.relation->weight.data(), control, i, position_[i],
                             n.position->data(), sum);
        }
        for (int c = 0; c < Dim; ++c) result[c] += sumLanes(sum[c]);
    }
    return result;
}

template <int Dim>
void Deformation<Dim>::fail(std::size_t i, const std::string& what, const Clock& clock) const {
    throw PhysicsError(fmt::format("particle {} of {} at {} {}, time {:g}",
                                   body_->particles.id()[i], body_->name,
                                   placeText<Dim>(position_[i]), what, clock.time));
}

template class Deformation<2>;
template class Deformation<3>;

}  // namespace sphinx::solid
