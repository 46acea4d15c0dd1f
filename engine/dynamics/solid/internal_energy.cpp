// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/internal_energy.h"

#include "core/sum_all.h"
#include "dynamics/solid/fibres.h"
#include "materials/elastic_laws.h"
#include "materials/strain.h"

namespace sphinx::dynamics::solid {
namespace {

/// sum_j k_ij abs(r_ij - F_i R_ij)^2 over one relation.
template <int Dim>
double unseenMotion(const ReferenceRelation<Dim>& relation, const Domain<Dim>& domain,
                    std::size_t i, const Mat<Dim>& F) {
    const double share = relation.from->elastic().share(i);
    ParticleSet<Dim>& from = relation.from->particles;
    ParticleSet<Dim>& to = relation.to->particles;
    const auto& from_start = from.vector(fields::initial_position);
    const auto& to_start = to.vector(fields::initial_position);
    double sum = 0;
    relation.list.forEach(i, [&](Index j, double mean_weight) {
        // The list has the mean share of both.
        const double weight = 2 * share / (share + relation.to->elastic().share(j)) * mean_weight;
        const Vec<Dim> R = domain.difference(from_start[i], to_start[j]);
        const Vec<Dim> r = domain.difference(from.position()[i], to.position()[j]);
        sum += weight * (r - F * R).squaredNorm();
    });
    return sum;
}

}  // namespace

template <int Dim>
double internalEnergy(Body<Dim>& body, Relations<Dim>& relations) {
    const bodies::ElasticRole<Dim>& role = body.elastic();
    const auto& gradient = body.particles.matrix(fields::deformation_gradient);
    const auto& volume = body.particles.scalar(fields::volume);
    const double elastic = materials::withLaw(*role.material, [&](const auto& law) {
        const ParticleFibres<Dim> fibres(body, std::decay_t<decltype(law)>::uses_fibres);
        return sumAll(body.size(), [&](std::size_t i) {
            if (role.share(i) == 0) return 0.0;
            return role.share(i) * volume[i] *
                   law.template energy<Dim>(materials::rightCauchyGreen<Dim>(gradient[i]),
                                            fibres[i]);
        });
    });
    if (role.hourglass_modulus == 0) return elastic;
    std::vector<const ReferenceRelation<Dim>*> sides;
    for (Body<Dim>* other : body.piece()) {
        ReferenceRelation<Dim>& relation = relations.reference(body, *other);
        relations.build(relation);
        sides.push_back(&relation);
    }
    const Domain<Dim>& domain = relations.domain();
    const double control = sumAll(body.size(), [&](std::size_t i) {
        if (role.share(i) == 0) return 0.0;
        double sum = 0;
        for (const auto* side : sides) sum += unseenMotion(*side, domain, i, gradient[i]);
        return 0.5 * role.hourglass_modulus * volume[i] * sum;
    });
    return elastic + control;
}

template double internalEnergy(Body<2>&, Relations<2>&);
template double internalEnergy(Body<3>&, Relations<3>&);

}  // namespace sphinx::dynamics::solid
