// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/check.h"

#include "case/build/loop.h"
#include "case/build/loop_facts.h"
#include "case/build/outputs.h"
#include "case/build/relaxed.h"
#include "case/build/world.h"
#include "case/check/rows.h"
#include "case/run/simulation.h"
#include "core/sum_all.h"
#include "materials/elastic_solid.h"
#include "neighbors/neighbor_list.h"

#include <fmt/format.h>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <system_error>

namespace sphinx::run {
namespace {

std::string sizeText(double bytes) {
    for (const char* name : {"B", "kB", "MB", "GB"}) {
        if (bytes < 1000) return fmt::format("{:.3g} {}", bytes, name);
        bytes /= 1000;
    }
    return fmt::format("{:.3g} TB", bytes);
}

/// Neighbors of a particle inside of a body, from the volume of the kernel's support.
template <int Dim>
double expectedNeighbors(const bodies::Body<Dim>& from, const bodies::Body<Dim>& to) {
    const double r = std::max(from.kernel.cutoff(), to.kernel.cutoff()) / to.spacing;
    return Dim == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

/// Particles, lists and the packed state of the acoustic step. Of other bodies than itself a body
/// sees only what is near their common surface, which is left out.
template <int Dim>
double memory(const bodies::World<Dim>& world) {
    double sum = 0;
    for (const auto& body : world.bodies) {
        const auto n = static_cast<double>(body->size());
        sum += static_cast<double>(body->particles.bytes()) + 64 * n;
        // Of eight neighbors; on a lattice the gradients of a reference list are few.
        const std::size_t block = body->isElastic()
                                      ? 2 * sizeof(Index)
                                      : sizeof(typename neighbors::NeighborList<Dim>::Block);
        for (const auto* other : body->sees)
            if (other == body.get())
                sum += n * expectedNeighbors(*body, *other) * 1.25 / lane_count *
                       static_cast<double>(block);
    }
    return sum;
}

void printLayer(const loop::Layer& layer, int depth, const std::string& time_unit,
                std::string& out) {
    const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
    std::string dt;
    for (const loop::TimeStep& estimate : layer.dt) dt += (dt.empty() ? "" : ", ") + estimate.label;
    if (layer.fixed_dt)
        dt += (dt.empty() ? "" : ", ") + fmt::format("{:g}{}", *layer.fixed_dt, time_unit);
    out += fmt::format("{}{} (dt: {})\n", indent, layer.name, dt);
    for (const loop::Step& step : layer.steps) {
        if (const auto* inner = std::get_if<loop::Layer>(&step.value)) {
            printLayer(*inner, depth + 1, time_unit, out);
            continue;
        }
        const auto& call = std::get<loop::Call>(step.value);
        out += fmt::format("{}  {}{}", indent, call.label, call.every ? " (sometimes)" : "");
        if (call.window.limited()) out += fmt::format(" ({})", describe(call.window, time_unit));
        out += '\n';
    }
}

/// ", volume 2 m^3, mass 2000 kg": of the particles, and that of the shape where it is another one,
/// because no lattice of the spacing fills it.
template <int Dim>
std::string massText(const bodies::World<Dim>& world, const bodies::Body<Dim>& body) {
    const particles::FieldBase* volume = body.particles.find(fields::volume.name);
    const particles::FieldBase* mass = body.particles.find(fields::mass.name);
    if (!volume || !mass) return "";
    const auto sum = [&](const particles::FieldBase& field) {
        return sumAll(body.size(), [&](std::size_t i) { return field.numbers()[i]; });
    };
    const double filled = sum(*volume);
    std::string text = fmt::format(", volume {}, mass {}", world.quantityText(filled, unit::volume),
                                   world.quantityText(sum(*mass), unit::mass));
    const double measure = body.shape ? body.shape->measure() : nan_value;
    if (std::abs(filled - measure) > 1e-6 * measure)
        text += fmt::format(" (its shape: {})", world.quantityText(measure, unit::volume));
    return text;
}

/// ", lattice moved by half a spacing in x, 8 of its points lie on the surface ...".
template <int Dim>
std::string latticeText(const build::PlacedLattice<Dim>& placed) {
    std::string axes;
    for (int k = 0; k < Dim; ++k)
        if (placed.moved[k]) axes += fmt::format("{}{}", axes.empty() ? "" : ", ", "xyz"[k]);
    if (placed.relaxed) return ", " + build::relaxedText(*placed.relaxed);
    std::string text;
    if (!axes.empty()) text += fmt::format(", lattice moved by half a spacing in {}", axes);
    if (placed.on_surface > 0)
        text += fmt::format(
            ", {} lattice point{} on its surface (kept where the body goes on towards larger "
            "coordinates: not symmetric)",
            placed.on_surface, placed.on_surface == 1 ? "" : "s");
    return text;
}

/// What its rows of particles make of its bending.
template <int Dim>
std::string bendingText(const bodies::Body<Dim>& body) {
    const std::size_t rows = check::rowsAcross(body);
    return check::bendingText(rows, check::bendingError(rows, body));
}

/// Writes of the whole run, with those at the start and at the end.
std::optional<double> writes(const model::Case& model, const input::Every& every) {
    const double span = model.loop.end_time - model.loop.start_time;
    if (every.by == input::Every::By::time) return std::floor(span / every.time) + 2;
    if (every.by == input::Every::By::ends) return 2;
    return {};
}

std::string everyText(const input::Every& every) {
    if (every.by == input::Every::By::steps)
        return fmt::format("every {} steps{}", every.steps,
                           every.layer.empty() ? "" : " of " + every.layer.text);
    return fmt::format("every {:g} s on the clock on the wall", every.wall_seconds);
}

/// The outputs, how often they write and how much at most: the files are compressed, and what did
/// not change is not written again.
template <int Dim>
std::string outputsText(const model::Case& model, const build::Outputs<Dim>& outputs,
                        input::Diagnostics& diagnostics) {
    std::string text = "outputs\n";
    double sum = 0;
    double most = 0;
    input::Place place;  // of the output that writes most
    for (std::size_t k = 0; k < model.outputs.size(); ++k) {
        const model::Output& source = model.outputs[k];
        double bytes = 0;
        for (const OutputFile& file : outputs.entries()[k].output->files()) bytes += file.bytes;
        const std::optional<double> times = writes(model, source.every);
        text += fmt::format("  {} ({}): {}", source.name, source.declaration->name(),
                            times ? fmt::format("{:.0f} times", *times) : everyText(source.every));
        if (bytes > 0)
            text += ", at most " + (times ? sizeText(*times * bytes) : sizeText(bytes) + " each");
        text += '\n';
        const double all = times.value_or(0) * bytes;
        sum += all;
        if (all > most) most = all, place = source.place;
    }
    std::error_code error;
    const auto space = std::filesystem::space(".", error);
    if (!error && sum > static_cast<double>(space.available))
        diagnostics.warning(
            place, fmt::format("the outputs may need {}, but the disk of this folder has {} left",
                               sizeText(sum), sizeText(static_cast<double>(space.available))));
    return text;
}

template <int Dim>
CheckReport check(const model::Case& model) {
    input::Diagnostics diagnostics;
    const build::PlacedFacts placed = build::loopFacts(model);
    build::checkLoop(placed, diagnostics);
    std::map<std::string, build::PlacedLattice<Dim>> lattices;
    const auto world = build::buildWorld<Dim>(model, true, diagnostics, &lattices);
    diagnostics.throwIfErrors();
    neighbors::Relations<Dim> relations(*world);
    dynamics::Context<Dim> context = build::makeContext<Dim>(model, *world, relations);
    build::Methods<Dim> methods(model, context);
    build::bindPlan<Dim>(placed.facts.plan, model, *world, methods);
    io::RestartHeader header;
    header.case_name = caseName(model);
    const build::Outputs<Dim> outputs(
        {model, *world, relations, {}, {}, {}, methods.all(), context.loads, header, {}, {}}, true);

    std::string out = "bodies\n";
    for (const auto& body : world->bodies) {
        const auto lattice = lattices.find(body->name);
        out += fmt::format("  {}: {} particles, spacing {}, {} with h {}{}{}\n", body->name,
                           body->size(), world->quantityText(body->spacing, unit::length),
                           kernels::kernelName(body->kernel.type()),
                           world->quantityText(body->kernel.smoothingLength(), unit::length),
                           massText(*world, *body),
                           lattice == lattices.end() ? "" : latticeText(lattice->second));
        if (body->isElastic()) out += "    " + bendingText(*body) + '\n';
    }
    out += fmt::format("domain: {} to {}\n", world->placeText(world->domain.bounds.lower),
                       world->placeText(world->domain.bounds.upper));
    out += fmt::format("memory: about {}\n", sizeText(memory(*world)));
    out += "loop\n";
    for (const loop::Call& line : placed.facts.plan.start)
        out += fmt::format("  start: {}\n", line.label);
    printLayer(placed.facts.plan.outermost, 1, placed.facts.time_unit, out);
    out += outputsText(model, outputs, diagnostics);
    return {model.warnings + diagnostics.text(), out};
}

}  // namespace

CheckReport checkCase(const model::Case& model) {
    return model.dimension == 2 ? check<2>(model) : check<3>(model);
}

}  // namespace sphinx::run
