// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/methods.h"
#include "neighbors/columns.h"

namespace sphinx::dynamics::particles {

/// Reorders the particles of a body as the sums over its pairs meet them (PairTiles), so that
/// neighbors in space are neighbors in memory. Changes no value; lists of the body must be rebuilt
/// afterwards.
void declareSort(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareBodyMethod<P>(
        registry, "particles.sort", []<int Dim>(const P&, Body<Dim>& body, Context<Dim>&) {
            return [&, columns = sphinx::neighbors::Columns<Dim>()](const Clock&) mutable {
                const Vec<Dim>* position = body.particles.position().data();
                const Box<Dim> bounds = sphinx::neighbors::boundsOf<Dim>(position, body.size());
                columns.build(position, body.size(), bounds, bounds.lower, body.spacing,
                              body.kernel.cutoff());
                body.particles.permute(columns.order());
                ++body.version;
            };
        });
    d.summary("Reorders the particles of a body in memory by place, for speed");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.trait("permutes");
    d.action().reads("body", {"position"});
}

}  // namespace sphinx::dynamics::particles
