// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/particles/sort.h"

namespace sphinx::dynamics::particles {

template <int Dim>
void Sort<Dim>::run(const Clock&) {
    const double cell_size = Dim == 2 ? body_->kernel.cutoff() : body_->spacing;
    grid_.build(body_->particles.position().data(), body_->size(), cell_size);
    body_->particles.permute(grid_.order());
    ++body_->version;
}

void declareSort(input::Registry& registry) {
    using P = SortParameters;
    auto& d = declareMethod<P>(registry, "particles.sort",
                               []<int Dim>(const P& p, Context<Dim>& context) {
                                   return std::make_unique<Sort<Dim>>(bodyOf(context, p.body));
                               });
    d.summary("Reorders the particles of a body in memory by place, for speed");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.trait("permutes");
    d.action().reads("body", {"position"});
}

template class Sort<2>;
template class Sort<3>;

}  // namespace sphinx::dynamics::particles
