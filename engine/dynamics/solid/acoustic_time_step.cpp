// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// The compiler may fuse products and sums here, and the bits depend on it: engine/CMakeLists.txt.
#ifndef SPHINX_FUSED
#error "compile this file with -ffp-contract=fast and SPHINX_FUSED"
#endif

#include "core/parallel.h"
#include "dynamics/group.h"
#include "dynamics/methods.h"
#include "dynamics/solid/fibres.h"
#include "materials/elastic_laws.h"
#include "materials/strain.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::solid {
namespace {

/// cfl min(h/(c + abs(v)), sqrt(h/abs(a))), c^2 = modulus / rho0 with the largest tangent modulus
/// of the present state; with Kelvin-Voigt damping eta also rho0 h^2 / (4 eta).
struct AcousticTimeStepParameters {
    input::Name body;
    double cfl = 0.6;
};

/// Largest modulus, squared speed and squared acceleration of the particles.
struct Largest {
    double modulus = 0;
    double speed2 = 0;
    double acceleration2 = 0;
};

template <int Dim>
double largestStep(Body<Dim>& body, double cfl, const Field<Vec<Dim>>& velocity,
                   const Field<Vec<Dim>>& acceleration, const Field<Mat<Dim>>& gradient) {
    const materials::ElasticSolid& solid = *body.elastic().material;
    const Largest largest = materials::withLaw(solid, [&](const auto& law) {
        const ParticleFibres<Dim> fibres(body, std::decay_t<decltype(law)>::uses_fibres);
        const std::size_t n = body.size();
        const std::vector<double>& shares = body.elastic().shares;
        return reduceAll(
            groupCount(n), Largest{},
            [&](std::size_t begin, std::size_t end) __attribute__((flatten)) {
                Wide modulus = 0, speed2 = 0, acceleration2 = 0;
                for (std::size_t number = begin; number < end; ++number) {
                    const Group group = groupOf(number, n);
                    const MatOf<Dim, Wide> C =
                        materials::rightCauchyGreen<Dim, Wide>(load(gradient, group));
                    Wide own = law.template tangentModulus<Dim, Wide>(C, fibres[group]);
                    if (!shares.empty())  // what a clamp covers whole has no stress
                        own = select(load(shares.data(), group) > 0, own, 0);
                    modulus = max(modulus, own);
                    speed2 = max(speed2, load(velocity, group).squaredNorm());
                    acceleration2 = max(acceleration2, load(acceleration, group).squaredNorm());
                }
                return Largest{maxOf(modulus), maxOf(speed2), maxOf(acceleration2)};
            },
            [](const Largest& a, const Largest& b) -> Largest {
                return {std::max(a.modulus, b.modulus), std::max(a.speed2, b.speed2),
                        std::max(a.acceleration2, b.acceleration2)};
            },
            group_block);
    });
    const double h = body.kernel.smoothingLength();
    const double rho0 = solid.density();
    double step = h / (std::sqrt(largest.modulus / rho0) + std::sqrt(largest.speed2));
    if (largest.acceleration2 > 0)
        step = std::min(step, std::sqrt(h / std::sqrt(largest.acceleration2)));
    step *= cfl;
    const double eta = solid.damping();
    if (eta > 0) step = std::min(step, 0.25 * rho0 * h * h / eta);
    return step;
}

}  // namespace

void declareAcousticTimeStep(input::Registry& registry) {
    using P = AcousticTimeStepParameters;
    auto& d = declareTimeStep<P>(
        registry, "solid.acoustic_time_step", []<int Dim>(const P& p, Body<Dim>& body) {
            const auto& velocity = body.particles.vector(fields::velocity);
            const auto& acceleration = body.particles.vector(fields::acceleration);
            const auto& gradient = body.particles.matrix(fields::deformation_gradient);
            return [&, cfl = p.cfl] {
                return largestStep<Dim>(body, cfl, velocity, acceleration, gradient);
            };
        });
    d.summary("Time step of an elastic body by its speed of sound, acceleration and damping");
    d.formula(
        "min(cfl h/(c + abs(v)), cfl sqrt(h/abs(a)), rho0 h^2/(4 eta)), c^2 = tangent "
        "modulus / rho0");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.optional("cfl", &P::cfl, input::number(unit::none).above(0).atMost(1), "factor");
    d.timeStep("").reads("body", {"velocity", "acceleration", "deformation_gradient"});
}

}  // namespace sphinx::dynamics::solid
