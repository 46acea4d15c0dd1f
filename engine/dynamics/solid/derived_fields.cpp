// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/derived_fields.h"

#include "core/parallel.h"
#include "dynamics/solid/fibres.h"
#include "materials/elastic_laws.h"
#include "materials/strain.h"

#include <Eigen/LU>
#include <cmath>

namespace sphinx::dynamics::solid {
namespace {

/// In space: a body in 2D does not change across the plane.
template <int Dim>
Mat<3> inSpace(const Mat<Dim>& F) {
    Mat<3> whole = Mat<3>::Identity();
    whole.template topLeftCorner<Dim, Dim>() = F;
    return whole;
}
template <int Dim>
materials::Fibres<3> inSpace(const materials::Fibres<Dim>& fibres) {
    materials::Fibres<3> whole;
    whole.fibre.template head<Dim>() = fibres.fibre;
    whole.sheet.template head<Dim>() = fibres.sheet;
    return whole;
}

double vonMises(const Mat<3>& stress) {
    const Mat<3> deviator = stress - stress.trace() / 3 * Mat<3>::Identity();
    return std::sqrt(1.5 * deviator.squaredNorm());
}

}  // namespace

template <int Dim>
void derive(Body<Dim>& body, const sphinx::particles::FieldInfo& field) {
    ParticleSet<Dim>& p = body.particles;
    const std::size_t n = body.size();
    if (&field == &fields::displacement) {
        auto& u = p.vector(field);
        const auto& start = p.vector(fields::initial_position);
        parallelFor(n, [&](std::size_t i) { u[i] = p.position()[i] - start[i]; });
        return;
    }
    const auto& gradient = p.matrix(fields::deformation_gradient);
    if (&field == &fields::green_lagrange_strain) {
        auto& E = p.matrix(field);
        parallelFor(n, [&](std::size_t i) {
            E[i] = materials::greenStrain<Dim>(materials::rightCauchyGreen<Dim>(gradient[i]));
        });
        return;
    }
    materials::withLaw(*body.elastic().material, [&](const auto& law) {
        const ParticleFibres<Dim> fibres(body, std::decay_t<decltype(law)>::uses_fibres);
        const auto stress = [&](std::size_t i) -> Mat<Dim> {
            return law.template stress<Dim>(materials::rightCauchyGreen<Dim>(gradient[i]),
                                            fibres[i]);
        };
        if (&field == &fields::piola_kirchhoff_stress) {
            auto& P = p.matrix(field);
            parallelFor(n, [&](std::size_t i) { P[i] = gradient[i] * stress(i); });
        } else if (&field == &fields::cauchy_stress) {
            auto& sigma = p.matrix(field);
            parallelFor(n, [&](std::size_t i) {
                const Mat<Dim>& F = gradient[i];
                sigma[i] = F * stress(i) * F.transpose() / F.determinant();
            });
        } else if (&field == &fields::von_mises_stress) {
            auto& out = p.scalar(field);
            parallelFor(n, [&](std::size_t i) {
                const Mat<3> F = inSpace<Dim>(gradient[i]);
                const Mat<3> S = law.template stress<3>(materials::rightCauchyGreen<3>(F),
                                                        inSpace<Dim>(fibres[i]));
                out[i] = vonMises(F * S * F.transpose() / F.determinant());
            });
        } else {
            auto& energy = p.scalar(field);
            parallelFor(n, [&](std::size_t i) {
                energy[i] = law.template energy<Dim>(materials::rightCauchyGreen<Dim>(gradient[i]),
                                                     fibres[i]);
            });
        }
    });
}

template void derive(Body<2>&, const sphinx::particles::FieldInfo&);
template void derive(Body<3>&, const sphinx::particles::FieldInfo&);

}  // namespace sphinx::dynamics::solid
