// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/checks.h"

#include "neighbors/list_builder.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace sphinx::check {
namespace {

/// Of what is compared in spacings.
constexpr double rounding = 1e-6;

/// Distance to the surface of its shape; 0 outside.
template <int Dim>
double depth(const bodies::Body<Dim>& body, std::size_t i) {
    return std::max(0.0, -body.shape->signedDistance(body.particles.position()[i]));
}

/// The particles of two bodies that are too near to each other.
template <int Dim>
struct Meeting {
    std::size_t count = 0;  ///< particles of a
    std::size_t a = 0;      ///< the pair of largest overlap, or the nearest one
    std::size_t b = 0;
    double distance = std::numeric_limits<double>::infinity();
    /// Length by which the shapes surely overlap: balls around both particles that lie within their
    /// shapes meet as far.
    double overlap = 0;
};

/// Lattices side by side keep a whole spacing: of the larger one, what is too near.
constexpr double too_near = 0.5 * (1 - rounding);
constexpr double side_by_side = 1.2;
/// Bodies that are farther from each other are meant to be apart.
constexpr double widest_gap = 4.5;

/// Particles nearer than so many spacings.
template <int Dim>
Meeting<Dim> meet(const bodies::World<Dim>& world, const bodies::Body<Dim>& a,
                  const bodies::Body<Dim>& b, bool shapes, double spacings = too_near) {
    const double spacing = std::max(a.spacing, b.spacing);
    const double limit = spacings * spacing;
    neighbors::CellGrid<Dim> grid_a;
    neighbors::CellGrid<Dim> grid_b;
    grid_a.build(a.particles.position().data(), a.size(), spacing);
    grid_b.build(b.particles.position().data(), b.size(), spacing);
    neighbors::NeighborList<Dim> list;
    const kernels::Kernel<Dim> kernel(kernels::KernelType::wendland_c2,
                                      limit / kernels::WendlandC2<Dim>::reach, limit);
    neighbors::buildList(grid_a, grid_b, false, kernel, world.domain, list);
    Meeting<Dim> meeting;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (list.ranges[i].count == 0) continue;
        ++meeting.count;
        const double depth_a = shapes ? depth(a, i) : 0;
        for (std::size_t k = 0; k < list.ranges[i].count; ++k) {
            const std::size_t j = list.of(i)[k / lane_count].index[k % lane_count];
            const double distance =
                world.domain.difference(a.particles.position()[i], b.particles.position()[j])
                    .norm();
            const double overlap = shapes ? depth_a + depth(b, j) - distance : 0;
            const bool farther = overlap > meeting.overlap + rounding * spacing;
            const bool nearer = meeting.overlap <= rounding * spacing &&
                                distance < meeting.distance - rounding * spacing;
            if (!farther && !nearer) continue;
            meeting.a = i;
            meeting.b = j;
            meeting.distance = distance;
            meeting.overlap = std::max(overlap, 0.0);
        }
    }
    return meeting;
}

/// By how many spacings the cell of a particle reaches out of its shape.
template <int Dim>
double beyond(const bodies::Body<Dim>& body, std::size_t i) {
    return 0.5 - depth(body, i) / body.spacing;
}

/// Why the cells of a lattice reach out of its shape at that particle.
template <int Dim>
std::string latticeText(const bodies::World<Dim>& world, const bodies::Body<Dim>& body,
                        std::size_t i) {
    const std::string what = fmt::format("cells of {} reach {:.2g} spacings out of its shape",
                                         body.name, beyond(body, i));
    const Vec<Dim>& x = body.particles.position()[i];
    const Vec<Dim> normal = body.shape->normal(x);
    int axis = 0;
    const double along = normal.cwiseAbs().maxCoeff(&axis);
    if (along < 1 - rounding) return what + ", whose surface does not run along the lattice there";
    const double extent = body.shape->bounds().size()[axis];
    const double cells = extent / body.spacing;
    if (std::abs(cells - std::round(cells)) > rounding * cells)
        return fmt::format("{}, whose extent in {}, {}, is {:.6g} spacings, no whole number", what,
                           "xyz"[axis], world.quantityText(extent, unit::length), cells);
    const double surface = x[axis] + std::copysign(depth(body, i), normal[axis]);
    return fmt::format(
        "{}, whose surface at {} = {} lies between the lines of the lattice: give "
        "its resolution an 'origin' there",
        what, "xyz"[axis], world.quantityText(surface, unit::length));
}

template <int Dim>
void checkPair(const model::Case& model, const bodies::World<Dim>& world,
               const bodies::Body<Dim>& a, const bodies::Body<Dim>& b,
               input::Diagnostics& diagnostics) {
    const model::Body& source = *model.findBody(a.name);
    const bool lattices =
        a.shape && b.shape && !source.particles && !model.findBody(b.name)->particles;
    const Meeting<Dim> meeting = meet(world, a, b, lattices);
    if (meeting.count == 0) return;
    const double spacing = std::max(a.spacing, b.spacing);
    const std::string place = world.placeText(a.particles.position()[meeting.a]);
    const std::string close =
        fmt::format("{} of its particles lie{} nearer than half a spacing to one of {}",
                    meeting.count, meeting.count == 1 ? "s" : "", b.name);
    if (meeting.overlap > rounding * spacing) {
        diagnostics.error(
            source.place,
            fmt::format("{} overlaps {} by {:.3g} spacings at {}: {}; subtract one shape from the "
                        "other",
                        a.name, b.name, meeting.overlap / spacing, place, close));
        return;
    }
    const std::string text =
        fmt::format("{} comes too near to {}: {}, down to {:.2g} spacings at {}", a.name, b.name,
                    close, meeting.distance / spacing, place);
    if (!lattices) {
        diagnostics.error(source.place, text);
        return;
    }
    const bool by_a = beyond(a, meeting.a) >= beyond(b, meeting.b);
    diagnostics.error(source.place, text + "; their shapes do not overlap there, but " +
                                        (by_a ? latticeText(world, a, meeting.a)
                                              : latticeText(world, b, meeting.b)));
}

/// A fluid goes through what it does not see.
template <int Dim>
void checkSight(const model::Case& model, const bodies::World<Dim>& world,
                const bodies::Body<Dim>& fluid, const bodies::Body<Dim>& other,
                input::Diagnostics& diagnostics) {
    if (std::ranges::find(fluid.sees, &other) != fluid.sees.end()) return;
    const Meeting<Dim> meeting = meet(world, fluid, other, false, side_by_side);
    if (meeting.count == 0) return;
    const std::string place = world.placeText(fluid.particles.position()[meeting.a]);
    // Of two fluids neither sees the other: see SenseCheck.
    diagnostics.warning(
        model.findBody(fluid.name)->place,
        other.isFluid()
            ? fmt::format("{0} and {1} meet at {2} and do not see each other: they will pass "
                          "through each other; the topology of each needs the other",
                          fluid.name, other.name, place)
            : fmt::format("{0} and {1} meet at {2}, but the topology of {0} lacks {1}: it will "
                          "pass through",
                          fluid.name, other.name, place));
}

/// A solid that a fluid sees and does not touch holds it only once the fluid has come up to it.
template <int Dim>
void checkGap(const model::Case& model, const bodies::World<Dim>& world,
              const bodies::Body<Dim>& fluid, const bodies::Body<Dim>& solid,
              input::Diagnostics& diagnostics) {
    if (std::ranges::find(fluid.sees, &solid) == fluid.sees.end()) return;
    // Most touch, and a narrow search tells so.
    if (meet(world, fluid, solid, false, side_by_side).count > 0) return;
    const Meeting<Dim> meeting = meet(world, fluid, solid, false, widest_gap);
    if (meeting.count == 0) return;
    const double spacing = std::max(fluid.spacing, solid.spacing);
    diagnostics.warning(
        model.findBody(fluid.name)->place,
        fmt::format("between {} and {} there is a gap of {:.2g} spacings at {}: particles side by "
                    "side are one spacing apart",
                    fluid.name, solid.name, meeting.distance / spacing - 1,
                    world.placeText(fluid.particles.position()[meeting.a])));
}

}  // namespace

template <int Dim>
void checkOverlap(const model::Case& model, const bodies::World<Dim>& world,
                  input::Diagnostics& diagnostics) {
    for (std::size_t m = 0; m < world.bodies.size(); ++m)
        for (std::size_t k = m + 1; k < world.bodies.size(); ++k) {
            const auto& a = *world.bodies[m];
            const auto& b = *world.bodies[k];
            if (a.isObserver() || b.isObserver()) continue;
            if (a.size() == 0 || b.size() == 0) continue;
            checkPair<Dim>(model, world, a, b, diagnostics);
            const auto& fluid = a.isFluid() ? a : b;
            const auto& other = a.isFluid() ? b : a;
            if (!fluid.isFluid()) continue;
            checkSight<Dim>(model, world, fluid, other, diagnostics);
            if (other.isSolid()) checkGap<Dim>(model, world, fluid, other, diagnostics);
        }
}

template void checkOverlap(const model::Case&, const bodies::World<2>&, input::Diagnostics&);
template void checkOverlap(const model::Case&, const bodies::World<3>&, input::Diagnostics&);

}  // namespace sphinx::check
