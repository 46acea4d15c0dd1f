// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/relaxed.h"

#include <fmt/format.h>
#include <utility>

namespace sphinx::build {
namespace {

/// A periodic side ends the body like a face of its shape: a row half a spacing from it meets that
/// of the other side. What reached across would be there twice.
template <int Dim>
void checkPeriodic(const model::Body& source, const bodies::Body<Dim>& body,
                   const bodies::World<Dim>& world, input::Diagnostics& diagnostics) {
    const Box<Dim> shape = body.shape->bounds();
    const Box<Dim>& domain = world.domain.bounds;
    const double rounding = 1e-6 * body.spacing;
    for (int k = 0; k < Dim; ++k) {
        if (!world.domain.periodic[static_cast<std::size_t>(k)]) continue;
        if (shape.lower[k] >= domain.lower[k] - rounding &&
            shape.upper[k] <= domain.upper[k] + rounding)
            continue;
        diagnostics.error(
            source.place,
            fmt::format("the shape of {} reaches across a periodic side in {}; with arrangement: "
                        "relaxed it must end there, since its particles are fitted to its surface",
                        body.name, "xyz"[k]));
        return;
    }
}

}  // namespace

template <int Dim>
void relaxPoints(const model::Body& source, const bodies::Body<Dim>& body,
                 const bodies::World<Dim>& world, PlacedLattice<Dim>& placed,
                 input::Diagnostics& diagnostics) {
    checkPeriodic(source, body, world, diagnostics);
    diagnostics.throwIfErrors();
    const fitting::RelaxLimits limits;
    placed.relaxed = fitting::relax(*body.shape, placed.lattice, body.kernel, limits);
    placed.points = std::exchange(placed.relaxed->points, {});
    const fitting::Relaxed<Dim>& relaxed = *placed.relaxed;
    if (relaxed.thin)
        diagnostics.error(
            source.place,
            fmt::format("{} is thinner than its spacing, {}, at {}: no particle stands half a "
                        "spacing inside of all its faces there, as arrangement: relaxed wants; a "
                        "finer spacing mends it",
                        body.name, world.quantityText(body.spacing, unit::length),
                        world.placeText(*relaxed.thin)));
    else if (!relaxed.converged && !placed.points.empty())
        diagnostics.warning(
            source.place,
            fmt::format("the particles of {} have not come to rest: after {} steps the residual is "
                        "{:.2g}, and not {:.2g}",
                        body.name, relaxed.steps, relaxed.residual, limits.residual));
}

template <int Dim>
std::string relaxedText(const fitting::Relaxed<Dim>& relaxed) {
    return fmt::format("relaxed in {} steps to a residual of {:.2g}, {} in the row at the surface",
                       relaxed.steps, relaxed.residual, relaxed.row);
}

template void relaxPoints(const model::Body&, const bodies::Body<2>&, const bodies::World<2>&,
                          PlacedLattice<2>&, input::Diagnostics&);
template void relaxPoints(const model::Body&, const bodies::Body<3>&, const bodies::World<3>&,
                          PlacedLattice<3>&, input::Diagnostics&);
template std::string relaxedText(const fitting::Relaxed<2>&);
template std::string relaxedText(const fitting::Relaxed<3>&);

}  // namespace sphinx::build
