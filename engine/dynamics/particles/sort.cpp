// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/methods.h"
#include "neighbors/cell_grid.h"

namespace sphinx::dynamics::particles {

/// Reorders the particles of a body cell by cell, so that neighbors in space are neighbors in
/// memory: in 2D by the cells of the lists, in 3D, where the particles around such a cell fill the
/// first cache, by rows of single particles. Changes no value; lists of the body must be rebuilt
/// afterwards.
void declareSort(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareBodyMethod<P>(
        registry, "particles.sort", []<int Dim>(const P&, Body<Dim>& body, Context<Dim>&) {
            return [&, grid = sphinx::neighbors::CellGrid<Dim>()](const Clock&) mutable {
                const double cell_size = Dim == 2 ? body.kernel.cutoff() : body.spacing;
                grid.build(body.particles.position().data(), body.size(), cell_size);
                body.particles.permute(grid.order());
                ++body.version;
            };
        });
    d.summary("Reorders the particles of a body in memory by place, for speed");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.trait("permutes");
    d.action().reads("body", {"position"});
}

}  // namespace sphinx::dynamics::particles
