// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check.h"

#include "case/build_world.h"
#include "case/loop_facts.h"
#include "neighbors/neighbor_list.h"

#include <fmt/format.h>
#include <cmath>
#include <numbers>

namespace sphinx::model {
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
double expectedNeighbors(const sphinx::Body<Dim>& from, const sphinx::Body<Dim>& to) {
    const double r = std::max(from.kernel.cutoff(), to.kernel.cutoff()) / to.spacing;
    return Dim == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

/// Particles, lists and the packed state of the acoustic step.
template <int Dim>
double memory(const World<Dim>& world) {
    double sum = 0;
    for (const auto& body : world.bodies) {
        const auto n = static_cast<double>(body->size());
        sum += static_cast<double>(body->particles.bytes()) + 64 * n;
        for (const auto* other : body->sees)
            if (other == body.get())
                sum += n * expectedNeighbors(*body, *other) * 1.25 / lane_count *
                       sizeof(PairBlock<Dim, float>);
    }
    return sum;
}

void printLayer(const loop::LayerFacts& layer, const Layer& source, int depth, std::string& out) {
    const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
    std::string dt;
    for (const loop::LineFacts& estimate : layer.dt)
        dt += (dt.empty() ? "" : ", ") + estimate.label;
    if (source.dt) dt += (dt.empty() ? "" : ", ") + fmt::format("{:g}", *source.dt);
    out += fmt::format("{}{} (dt: {})\n", indent, layer.name, dt);
    for (std::size_t k = 0; k < layer.steps.size(); ++k) {
        const auto& value = layer.steps[k].value;
        if (const auto* inner = std::get_if<loop::LayerFacts>(&value)) {
            printLayer(*inner, *source.steps[k].layer, depth + 1, out);
            continue;
        }
        const auto& line = std::get<loop::LineFacts>(value);
        out += fmt::format("{}  {}{}\n", indent, line.label, line.sometimes ? " (sometimes)" : "");
    }
}

std::string outputText(const Case& model, const Output& output, double particles) {
    const double span = model.loop.end_time - model.loop.start_time;
    std::string text = fmt::format("  {} ({})", output.name, output.declaration->name());
    if (output.every.by != Every::By::time) return text + "\n";
    const double frames = std::floor(span / output.every.time) + 2;
    text += fmt::format(": {:.0f} times", frames);
    // Position, id, mass and about four more numbers a particle.
    const bool heavy = output.declaration->hasTrait("frames");
    if (heavy) text += fmt::format(", about {}", sizeText(frames * particles * 80));
    return text + "\n";
}

template <int Dim>
std::string check(const Case& model) {
    input::Diagnostics diagnostics;
    const PlacedFacts placed = loopFacts(model);
    checkLoop(placed, diagnostics);
    const auto world = buildWorld<Dim>(model, true, diagnostics);
    diagnostics.throwIfErrors();

    std::string out = model.warnings + diagnostics.text();
    double particles = 0;
    out += "bodies\n";
    for (const auto& body : world->bodies) {
        out += fmt::format("  {}: {} particles, spacing {:g}, h {:g}\n", body->name, body->size(),
                           body->spacing, body->kernel.smoothingLength());
        if (body->kind != BodyKind::observer) particles += static_cast<double>(body->size());
    }
    out += fmt::format("memory: about {}\n", sizeText(memory(*world)));
    out += "loop\n";
    for (const loop::LineFacts& line : placed.facts.start)
        out += fmt::format("  start: {}\n", line.label);
    printLayer(placed.facts.outermost, model.loop.layer, 1, out);
    out += "outputs\n";
    for (const Output& output : model.outputs) out += outputText(model, output, particles);
    return out;
}

}  // namespace

std::string checkCase(const Case& model) {
    return model.dimension == 2 ? check<2>(model) : check<3>(model);
}

}  // namespace sphinx::model
