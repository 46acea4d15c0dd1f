// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// The compiler may fuse products and sums here, and the bits depend on it: engine/CMakeLists.txt.
#ifndef SPHINX_FUSED
#error "compile this file with -ffp-contract=fast and SPHINX_FUSED"
#endif

#include "dynamics/solid/acoustic_time_step.h"

#include "core/parallel.h"
#include "dynamics/group.h"
#include "dynamics/solid/fibres.h"
#include "materials/elastic_laws.h"
#include "materials/strain.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::solid {
namespace {

/// Largest modulus, squared speed and squared acceleration of the particles.
struct Largest {
    double modulus = 0;
    double speed2 = 0;
    double acceleration2 = 0;
};

}  // namespace

template <int Dim>
AcousticTimeStep<Dim>::AcousticTimeStep(Body<Dim>& body, double cfl)
    : body_(&body),
      solid_(body.elastic().material.get()),
      cfl_(cfl),
      velocity_(body.particles.vector(fields::velocity)),
      acceleration_(body.particles.vector(fields::acceleration)),
      gradient_(body.particles.matrix(fields::deformation_gradient)) {}

template <int Dim>
double AcousticTimeStep<Dim>::estimate() {
    const Largest largest = materials::withLaw(*solid_, [&](const auto& law) {
        const ParticleFibres<Dim> fibres(*body_, std::decay_t<decltype(law)>::uses_fibres);
        const std::size_t n = body_->size();
        const std::vector<double>& shares = body_->elastic().shares;
        return reduceAll(
            groupCount(n), Largest{},
            [&](std::size_t begin, std::size_t end) {
                Wide modulus = 0, speed2 = 0, acceleration2 = 0;
                for (std::size_t number = begin; number < end; ++number) {
                    const Group group = groupOf(number, n);
                    const MatOf<Dim, Wide> C =
                        materials::rightCauchyGreen<Dim, Wide>(load(gradient_, group));
                    Wide own = law.template tangentModulus<Dim, Wide>(C, fibres[group]);
                    if (!shares.empty())  // what a clamp covers whole has no stress
                        own = select(load(shares.data(), group) > 0, own, 0);
                    modulus = max(modulus, own);
                    speed2 = max(speed2, load(velocity_, group).squaredNorm());
                    acceleration2 = max(acceleration2, load(acceleration_, group).squaredNorm());
                }
                return Largest{maxOf(modulus), maxOf(speed2), maxOf(acceleration2)};
            },
            [](const Largest& a, const Largest& b) -> Largest {
                return {std::max(a.modulus, b.modulus), std::max(a.speed2, b.speed2),
                        std::max(a.acceleration2, b.acceleration2)};
            },
            group_block);
    });
    const double h = body_->kernel.smoothingLength();
    const double rho0 = solid_->density();
    double step = h / (std::sqrt(largest.modulus / rho0) + std::sqrt(largest.speed2));
    if (largest.acceleration2 > 0)
        step = std::min(step, std::sqrt(h / std::sqrt(largest.acceleration2)));
    step *= cfl_;
    const double eta = solid_->damping();
    if (eta > 0) step = std::min(step, 0.25 * rho0 * h * h / eta);
    return step;
}

void declareAcousticTimeStep(input::Registry& registry) {
    using P = AcousticTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "solid.acoustic_time_step", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<AcousticTimeStep<Dim>>(bodyOf(context, p.body), p.cfl);
        });
    d.summary("Time step of an elastic body by its speed of sound, acceleration and damping");
    d.formula(
        "min(cfl h/(c + abs(v)), cfl sqrt(h/abs(a)), rho0 h^2/(4 eta)), c^2 = tangent "
        "modulus / rho0");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1), "factor");
    d.timeStep("").reads("body", {"velocity", "acceleration", "deformation_gradient"});
}

template class AcousticTimeStep<2>;
template class AcousticTimeStep<3>;

}  // namespace sphinx::dynamics::solid
