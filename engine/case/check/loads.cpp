// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/loads.h"

#include "dynamics/constraint/clamp.h"
#include "dynamics/constraint/prescribed_motion.h"
#include "dynamics/force/surface_pressure.h"
#include "input/expressions/vector_at_time.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace sphinx::model {
namespace {

template <int Dim>
void checkMotion(const Component& method, const World<Dim>& world, double start_time,
                 input::Diagnostics& diagnostics) {
    const auto& p = method.as<constraint::PrescribedMotionParameters>();
    const sphinx::Part<Dim> part(world, p.part);
    const input::VectorAtTime<Dim> displacement(p.displacement, start_time);
    for (std::size_t n = 0; n < part.size(); ++n) {
        const Vec<Dim>& x = part.body().particles.position()[part[n]];
        Vec<Dim> u = displacement(x);
        for (int c = 0; c < Dim && !p.directions.empty(); ++c)
            if (std::find(p.directions.begin(), p.directions.end(), c) == p.directions.end())
                u[c] = 0;
        if (u.norm() <= 1e-9 * part.body().spacing) continue;
        diagnostics.error(
            method.placeOf("displacement"),
            fmt::format("the displacement at {} is {} at the start, but must be zero there: the "
                        "particles start where the shape has them",
                        world.placeText(x), world.placeText(u)));
        return;
    }
}

template <int Dim>
void checkSurface(const Component& method, const World<Dim>& world,
                  input::Diagnostics& diagnostics) {
    const auto& p = method.as<force::SurfacePressureParameters>();
    const sphinx::Part<Dim> part(world, p.part);
    if (p.normal.empty()) {
        if (!part.body().shape)
            diagnostics.error(method.place, fmt::format("{} has no shape that tells the normal of "
                                                        "its surface: give 'normal'",
                                                        part.body().name));
        return;
    }
    const input::VectorAtTime<Dim> normal(p.normal, 0);
    for (std::size_t n = 0; n < part.size(); ++n) {
        const Vec<Dim>& x = part.body().particles.position()[part[n]];
        const double length = normal(x).norm();
        if (length > 0 && std::isfinite(length)) continue;
        diagnostics.error(method.placeOf("normal"),
                          fmt::format("the normal has no direction at {}: its length is {:g}",
                                      world.placeText(x), length));
        return;
    }
}

template <int Dim>
void checkClamp(const Component& method, const World<Dim>& world, input::Diagnostics& diagnostics) {
    const auto& p = method.as<constraint::ClampParameters>();
    const sphinx::Part<Dim> part(world, p.part);
    if (part.size() < part.body().size()) return;
    diagnostics.error(
        p.part.place,
        fmt::format("nothing of {} would be left to move: a clamp needs a part of it, "
                    "on whose surface it holds the other particles",
                    part.body().name));
}

}  // namespace

template <int Dim>
void checkLoads(const Case& model, const World<Dim>& world, input::Diagnostics& diagnostics) {
    for (const Component& method : model.dynamics) {
        if (method.declaration->name() == "constraint.clamp")
            checkClamp<Dim>(method, world, diagnostics);
        if (method.declaration->name() == "constraint.prescribed_motion")
            checkMotion<Dim>(method, world, model.loop.start_time, diagnostics);
        if (method.declaration->name() == "force.surface_pressure")
            checkSurface<Dim>(method, world, diagnostics);
    }
}

template void checkLoads(const Case&, const World<2>&, input::Diagnostics&);
template void checkLoads(const Case&, const World<3>&, input::Diagnostics&);

}  // namespace sphinx::model
