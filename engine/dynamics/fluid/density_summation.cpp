// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "materials/fluid.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

enum class Surface { free, confined };

/// Re-initialisation of the density by summation, guide (54) and (55):
///   free:     rho_i = max(rho_i, rho0 S_i/S0)
///   confined: rho_i = rho_i(start) S_i/S0, so that an initial pressure is kept
/// S_i = W(0) + sum_j W_ij over the fluid and the solids it sees; a neighbor of another spacing
/// counts with V_j0/V_i0. S0 is the sum over the full lattice of the body.
struct DensitySummationParameters {
    input::Name body;
    Surface surface = Surface::free;
};

/// What the neighbors in one body add to S_i, each of them.
template <int Dim>
struct Term {
    const Relation<Dim>* relation;
    double weight;
};

}  // namespace

void declareDensitySummation(input::Registry& registry) {
    using P = DensitySummationParameters;
    auto& d = declareBodyMethod<P>(
        registry, "fluid.density_summation",
        []<int Dim>(const P& p, Body<Dim>& body, Context<Dim>& context) {
            std::vector<Term<Dim>> terms;
            for (Body<Dim>* other : body.sees)
                terms.push_back({&context.relations.flow(body, *other, {.kernel_sum = true}),
                                 std::pow(other->spacing / body.spacing, Dim)});
            auto& density = body.particles.scalar(fields::density);
            const bool free = p.surface == Surface::free;
            const Field<double>* reference =
                free ? nullptr : &body.particles.scalar(fields::reference_density);
            const double rho0 = body.fluid().material->density();
            return [&, terms, free, reference, rho0, own = body.kernel.value(0),
                    lattice_sum = body.kernel.latticeSum()](const Clock&) {
                parallelRanges(body.size(), [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                        double sum = own;
                        for (const Term<Dim>& term : terms)
                            sum += term.weight * term.relation->list.kernel_sum[i];
                        const double ratio = sum / lattice_sum;
                        density[i] =
                            free ? std::max(density[i], rho0 * ratio) : (*reference)[i] * ratio;
                    }
                });
            };
        });
    d.summary("Density from the sum of the kernel over the neighbors");
    d.formula("guide (54) free: max(rho, rho0 S/S0); (55) confined: rho(start) S/S0");
    d.cite("guide", "(54), (55)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("surface", &P::surface,
               input::choice<Surface>({
                   {"free", Surface::free, "flow with a free surface"},
                   {"confined", Surface::confined, "flow without free surface"},
               }),
               "whether the fluid has a free surface");
    d.trait("sums_over_itself");
    d.action()
        .reads("body", {"density", "reference_density", "fresh_neighbors"})
        .writes("body", {"density"});
}

}  // namespace sphinx::dynamics::fluid
