// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/density_summation.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>

namespace sphinx::dynamics::fluid {

template <int Dim>
DensitySummation<Dim>::DensitySummation(Context<Dim>& context, Body<Dim>& body, Surface surface)
    : body_(&body),
      surface_(surface),
      rho0_(body.fluid().material->density()),
      own_(body.kernel.value(0)),
      lattice_sum_(body.kernel.latticeSum()),
      density_(body.particles.scalar(fields::density)) {
    if (surface == Surface::confined)
        reference_ = &body.particles.scalar(fields::reference_density);
    for (Body<Dim>* other : body.sees) {
        terms_.push_back({&context.relations.flow(body, *other, {.kernel_sum = true}),
                          std::pow(other->spacing / body.spacing, Dim)});
    }
}

template <int Dim>
void DensitySummation<Dim>::run(const Clock&) {
    parallelRanges(body_->size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            double sum = own_;
            for (const Term& term : terms_) sum += term.weight * term.relation->list.kernel_sum[i];
            const double ratio = sum / lattice_sum_;
            density_[i] = surface_ == Surface::free ? std::max(density_[i], rho0_ * ratio)
                                                    : (*reference_)[i] * ratio;
        }
    });
}

void declareDensitySummation(input::Registry& registry) {
    using P = DensitySummationParameters;
    auto& d = declareMethod<P>(registry, "fluid.density_summation",
                               []<int Dim>(const P& p, Context<Dim>& context) {
                                   return std::make_unique<DensitySummation<Dim>>(
                                       context, bodyOf(context, p.body), p.surface);
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

template class DensitySummation<2>;
template class DensitySummation<3>;

}  // namespace sphinx::dynamics::fluid
