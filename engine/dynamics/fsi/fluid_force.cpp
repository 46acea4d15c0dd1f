// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/fluid_force.h"

#include <fmt/format.h>

namespace sphinx::dynamics::fsi {

template <int Dim>
FluidForce<Dim>::FluidForce(Context<Dim>& context, Body<Dim>& solid, Body<Dim>& fluid,
                            fluid::LoadKind kind, Field<Vec<Dim>>& force)
    : context_(&context),
      solid_(&solid),
      fluid_(&fluid),
      kind_(kind),
      relation_(&context.relations.flow(solid, fluid, {.distance = true})),
      force_(force) {}

template <int Dim>
void FluidForce<Dim>::run(const Clock&) {
    if (const auto* load = fluid::presentLoad(context_->loads, *fluid_, kind_))
        load->addForces(*solid_, relation_->list, force_);
}

void checkSight(const input::Component& method, WrittenCase& written) {
    const auto& [body, from] = method.as<FluidForceParameters>();
    if (!written.sees(from.text, body.text))
        written.diagnostics.error(
            from.place, fmt::format("{} does not see {}: the topology of {} lacks '{}'", from.text,
                                    body.text, from.text, body.text));
}

template class FluidForce<2>;
template class FluidForce<3>;

}  // namespace sphinx::dynamics::fsi
