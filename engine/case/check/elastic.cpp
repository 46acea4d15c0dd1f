// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/checks.h"

#include "case/check/rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sphinx::check {

namespace {

/// From the first to the last particle of the body and those bonded to it, along each axis.
template <int Dim>
Vec<Dim> extentOf(const bodies::Body<Dim>& body) {
    Box<Dim> box;
    for (const bodies::Body<Dim>* piece : body.piece())
        for (std::size_t i = 0; i < piece->size(); ++i) box.include(piece->particles.position()[i]);
    return box.size();
}

/// A single row of particles has no gradients across it.
template <int Dim>
void checkRows(const model::Body& source, const bodies::Body<Dim>& body, const Vec<Dim>& extent,
               const bodies::World<Dim>& world, input::Diagnostics& diagnostics) {
    for (int axis = 0; axis < Dim; ++axis) {
        if (extent[axis] > 0.5 * body.spacing) continue;
        diagnostics.error(
            source.place,
            fmt::format("{} has one row of particles in {}, and an elastic body needs two at least "
                        "(six for bending): its spacing is {}",
                        body.name, "xyz"[axis], world.quantityText(body.spacing, unit::length)));
        return;
    }
}

/// Few rows of particles bend otherwise than the body would.
template <int Dim>
void checkBending(const model::Body& source, const bodies::Body<Dim>& body,
                  input::Diagnostics& diagnostics) {
    constexpr double tolerated = 0.1;
    const std::size_t rows = rowsAcross(body);
    if (rows < 2) return;  // an error, or no beam
    const double error = bendingError(rows, body);
    if (std::abs(error) <= tolerated) return;
    diagnostics.warning(source.place,
                        fmt::format("{} has {}: a finer spacing, or 'spacing' or 'level' in "
                                    "bodies.{}.resolution, makes more rows",
                                    body.name, bendingText(rows, error), body.name));
}

}  // namespace

template <int Dim>
void checkElastic(const model::Case& model, const bodies::World<Dim>& world,
                  input::Diagnostics& diagnostics) {
    for (const model::Body& source : model.bodies) {
        if (source.role != bodies::Role::elastic) continue;
        const bodies::Body<Dim>& body = *world.find(source.name);
        const Vec<Dim> extent = extentOf(body);
        checkRows(source, body, extent, world, diagnostics);
        checkBending(source, body, diagnostics);
        for (int axis = 0; axis < Dim; ++axis) {
            if (!world.domain.periodic[axis]) continue;
            const double gap = world.domain.bounds.size()[axis] - extent[axis];
            const double reach = body.kernel.cutoff();
            if (!(gap < reach)) continue;
            diagnostics.error(
                source.place,
                fmt::format(
                    "{} is elastic and reaches across the periodic side in {}: its particles "
                    "must leave a gap of {} or more, here it is {}",
                    body.name, "xyz"[axis], world.quantityText(reach, unit::length),
                    world.quantityText(std::max(gap, 0.0), unit::length)));
            break;
        }
    }
}

template void checkElastic(const model::Case&, const bodies::World<2>&, input::Diagnostics&);
template void checkElastic(const model::Case&, const bodies::World<3>&, input::Diagnostics&);

}  // namespace sphinx::check
