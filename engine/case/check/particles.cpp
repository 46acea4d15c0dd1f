// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/checks.h"

#include "core/memory_limit.h"
#include "core/sum_all.h"
#include "particles/lattice.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace sphinx::check {
namespace {

/// More particles have no 32-bit index; some of the box around a body may be empty.
constexpr double most_lattice_points = 1e10;
/// What a particle needs at least (position, velocity, mass, ...), without its lists.
constexpr double bytes_of_particle = 100;
/// Lattices are counted by a sample where they have more points than that.
constexpr double sampled_points = 1e6;
/// Of the volume of a shape: what that of its particles may differ without a word.
constexpr double most_volume_error = 0.01;

/// Number of lattice points in a shape, from a coarser lattice where there are many.
template <int Dim>
double countAbout(const geometry::Shape<Dim>& shape, double spacing) {
    const double cells = (shape.bounds().size() / spacing).prod();
    const double ratio = std::max(1.0, std::pow(cells / sampled_points, 1.0 / Dim));
    const auto sample =
        particles::latticePoints<Dim>(shape, {ratio * spacing, shape.bounds().lower});
    return static_cast<double>(sample.size()) * std::pow(ratio, Dim);
}

template <int Dim>
void checkDomain(const model::Body& source, const bodies::Body<Dim>& body,
                 const bodies::World<Dim>& world, input::Diagnostics& diagnostics) {
    if (body.isSolid()) return;
    const auto& position = body.particles.position();
    std::size_t outside = 0;
    std::size_t first = 0;
    for (std::size_t i = body.size(); i-- > 0;)
        if (!world.domain.bounds.contains(position[i])) {
            ++outside;
            first = i;
        }
    if (outside == 0) return;
    if (body.isFluid())
        diagnostics.error(
            source.place,
            fmt::format("{} of {} particles of {} start outside of the domain, the "
                        "first at {}; enlarge the domain or cut the shape",
                        outside, body.size(), body.name, world.placeText(position[first])));
    else
        diagnostics.warning(
            source.place,
            fmt::format("{} of {} points of {} {} outside of the domain, the "
                        "first at {}",
                        outside, body.size(), body.name, outside == 1 ? "lies" : "lie",
                        world.placeText(position[first])));
}

/// The lattice of a body that reaches from side to side has a seam where the period is no multiple
/// of its spacing.
template <int Dim>
void checkClosing(const model::Body& source, const bodies::Body<Dim>& body,
                  const bodies::World<Dim>& world, int axis, input::Diagnostics& diagnostics) {
    const Box<Dim>& domain = world.domain.bounds;
    const Box<Dim> shape = body.shape->bounds();
    const double period = domain.upper[axis] - domain.lower[axis];
    const double cells = period / body.spacing;
    constexpr double rounding = 1e-6;
    const double slack = 0.5 * body.spacing;
    if (shape.lower[axis] > domain.lower[axis] + slack ||
        shape.upper[axis] < domain.upper[axis] - slack ||
        std::abs(cells - std::round(cells)) <= rounding * cells)
        return;
    const auto length = [&](double value) { return world.quantityText(value, unit::length); };
    const double fewer = std::floor(cells), more = fewer + 1;
    diagnostics.error(
        source.place,
        fmt::format("the period in {}, {}, is {:.6g} spacings of {}, no whole number: its lattice "
                    "would have a seam. Periods that fit: {} and {}; spacings that fit: {} and {}",
                    "xyz"[axis], length(period), cells, body.name, length(fewer * body.spacing),
                    length(more * body.spacing), length(period / more), length(period / fewer)));
}

/// Nearer images of a particle than its reach would be its neighbors.
template <int Dim>
void checkPeriod(const model::Body& source, const bodies::Body<Dim>& body,
                 const bodies::World<Dim>& world, input::Diagnostics& diagnostics) {
    const bodies::Domain<Dim>& domain = world.domain;
    for (int axis = 0; axis < Dim; ++axis) {
        const double period = domain.bounds.upper[axis] - domain.bounds.lower[axis];
        if (domain.periodic[axis] && period < body.kernel.cutoff())
            diagnostics.error(
                source.place,
                fmt::format("the period in {} is {} but must be at least {}, the "
                            "reach of the kernel of {}",
                            "xyz"[axis], world.quantityText(period, unit::length),
                            world.quantityText(body.kernel.cutoff(), unit::length), body.name));
        if (domain.periodic[axis] && body.shape && !source.particles && body.on_lattice)
            checkClosing(source, body, world, axis, diagnostics);
    }
}

/// An expression of place may have no value somewhere, and a fluid bears no pressure at which its
/// density would not be positive.
template <int Dim>
void checkInitialValues(const model::Body& source, const bodies::Body<Dim>& body,
                        const bodies::World<Dim>& world, input::Diagnostics& diagnostics) {
    const auto report = [&](const particles::FieldInfo& field, double value, const Vec<Dim>& at) {
        diagnostics.error(source.place,
                          fmt::format("the initial {} of {} is {} at {}", field.name, body.name,
                                      world.quantityText(value, field.unit), world.placeText(at)));
    };
    auto& particles = body.particles;
    const auto& velocity = particles.vector(fields::velocity);
    const auto& density = particles.scalar(fields::density);
    const auto& volume = particles.scalar(fields::volume);
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Vec<Dim>& x = particles.position()[i];
        if (!(volume[i] > 0)) return report(fields::volume, volume[i], x);
        if (!velocity[i].allFinite()) return report(fields::velocity, velocity[i].norm(), x);
        if (!source.initial.pressure) continue;
        const double pressure = particles.scalar(fields::pressure)[i];
        if (!std::isfinite(pressure)) return report(fields::pressure, pressure, x);
        if (density[i] > 0 && std::isfinite(density[i])) continue;
        diagnostics.error(
            source.place,
            fmt::format("the initial pressure of {} is {} at {}, at which its density would be {} "
                        "but must be above 0",
                        body.name, world.quantityText(pressure, unit::pressure), world.placeText(x),
                        world.quantityText(density[i], unit::density)));
        return;
    }
}

/// Lattices of coarse spacing have another volume than their shape, and so another mass.
template <int Dim>
void checkMass(const model::Body& source, const bodies::Body<Dim>& body,
               const bodies::World<Dim>& world, input::Diagnostics& diagnostics) {
    if (!body.shape || source.particles || body.isWall()) return;
    const double shape = body.shape->measure();
    const auto& volume = body.particles.scalar(fields::volume);
    const double filled = sumAll(body.size(), [&](std::size_t i) { return volume[i]; });
    if (!(std::abs(filled - shape) > most_volume_error * shape)) return;
    std::string extents;
    for (int k = 0; k < Dim; ++k)
        extents += fmt::format("{}{:.4g}", k == 0 ? "" : " x ",
                               body.shape->bounds().size()[k] / body.spacing);
    diagnostics.warning(
        source.place,
        fmt::format("the particles of {} have {:+.2g} % of the volume of its shape, {} for {}: the "
                    "shape measures {} spacings. A spacing that divides its extents, or a finer "
                    "one, mends it",
                    body.name, 100 * (filled / shape - 1), world.quantityText(filled, unit::volume),
                    world.quantityText(shape, unit::volume), extents));
}

}  // namespace

template <int Dim>
void checkParticles(const model::Case& model, const bodies::World<Dim>& world,
                    input::Diagnostics& diagnostics) {
    for (const model::Body& source : model.bodies) {
        const bodies::Body<Dim>& body = *world.find(source.name);
        if (body.size() == 0) {
            diagnostics.error(
                source.place,
                fmt::format("{} has no particles: its shape holds no point of the lattice of "
                            "spacing {}",
                            body.name, world.quantityText(body.spacing, unit::length)));
            continue;
        }
        for (std::size_t k = 0; k < body.parts.size(); ++k)
            if (body.parts[k].particles.empty())
                diagnostics.error(source.parts[k].place,
                                  fmt::format("the part '{}' of {} holds none of its particles",
                                              body.parts[k].name, body.name));
        checkDomain<Dim>(source, body, world, diagnostics);
        if (body.isObserver()) continue;
        checkPeriod<Dim>(source, body, world, diagnostics);
        checkInitialValues<Dim>(source, body, world, diagnostics);
    }
    checkOverlap<Dim>(model, world, diagnostics);
    if (diagnostics.hasErrors()) return;  // which may be the reason
    for (const model::Body& source : model.bodies)
        checkMass<Dim>(source, *world.find(source.name), world, diagnostics);
}

template <int Dim>
void checkLattices(const model::Case& model, input::Diagnostics& diagnostics) {
    const std::string length = model.units.suffix(unit::length);
    const MemoryLimit memory = memoryLimit();
    for (const model::Body& source : model.bodies) {
        if (source.shape.empty() || source.particles) continue;
        const auto& shape = *model.findShape(source.shape.text)->as<Dim>();
        if (shape.empty()) continue;
        const double spacing = source.spacing(model.resolution);
        const Vec<Dim> cells = shape.bounds().size() / spacing;
        if (!(cells.prod() <= most_lattice_points && cells.maxCoeff() <= most_lattice_points)) {
            diagnostics.error(
                source.place,
                fmt::format("the lattice of spacing {:g}{} has {:.3g} points in the box "
                            "around {}; the most is {:.0e}",
                            spacing, length, cells.prod(), source.name, most_lattice_points));
            continue;
        }
        if (cells.prod() <= sampled_points) continue;
        const double count = countAbout<Dim>(shape, spacing);
        if (count * bytes_of_particle > memory.bytes)
            diagnostics.error(
                source.place,
                fmt::format("the lattice of spacing {:g}{} gives {} about {:.1g} particles, which "
                            "do not fit in the memory of {} ({:.2g} GB)",
                            spacing, length, source.name, count,
                            memory.of_group ? "the cgroup of this process" : "this machine",
                            memory.bytes / 1e9));
    }
}

template void checkLattices<2>(const model::Case&, input::Diagnostics&);
template void checkLattices<3>(const model::Case&, input::Diagnostics&);
template void checkParticles(const model::Case&, const bodies::World<2>&, input::Diagnostics&);
template void checkParticles(const model::Case&, const bodies::World<3>&, input::Diagnostics&);

}  // namespace sphinx::check
