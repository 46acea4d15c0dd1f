// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/simulation.h"

#include "case/build/relaxed.h"
#include "case/build/world.h"
#include "case/run/physics_text.h"
#include "case/run/provenance.h"
#include "case/run/restart_fields.h"
#include "core/errors.h"
#include "io/file/compress.h"

#include <fmt/format.h>
#include <filesystem>
#include <utility>

namespace sphinx::run {
namespace {

/// It asks the system, which takes as long as a step of a small body.
constexpr double seconds_between_watches = 0.1;

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(const model::Case& model, const RunOptions& options, io::Path folder,
                            io::Provenance provenance)
    : model_(model),
      options_(options),
      folder_(std::move(folder)),
      provenance_(std::move(provenance)),
      placed_(build::loopFacts(model)) {
    input::Diagnostics diagnostics;
    build::checkLoop(placed_, diagnostics);
    diagnostics.throwIfErrors();
    std::map<std::string, build::PlacedLattice<Dim>> lattices;
    world_ = build::buildWorld<Dim>(model, !resuming(), diagnostics, &lattices);
    diagnostics.throwIfErrors();
    for (const auto& [name, placed] : lattices)
        if (placed.relaxed) arrangements_[name] = build::relaxedText(*placed.relaxed);
    warnings_ = diagnostics.text();
    relations_ = std::make_unique<neighbors::Relations<Dim>>(*world_);
    context_.emplace(build::makeContext<Dim>(model_, *world_, *relations_));
    methods_ = std::make_unique<build::Methods<Dim>>(model, *context_);
}

template <int Dim>
void Simulation<Dim>::prepare() {
    loop::Plan plan = build::bindPlan<Dim>(placed_.facts.plan, model_, *world_, *methods_);
    const build::OutputTools<Dim> tools{model_,
                                        *world_,
                                        *relations_,
                                        folder_,
                                        provenance_,
                                        [this] { return runner_->progress(); },
                                        methods_->all(),
                                        context_->loads,
                                        restartHeader(),
                                        restartBodies(),
                                        [this](Archive& archive) { transfer(archive); }};
    outputs_.emplace(tools, options_.outputs);
    outputs_->addTo(plan);
    runner_ = std::make_unique<loop::Runner>(std::move(plan));
    runner_->watchWrites([this] { before_writes_(); });
    if (resuming()) restore();
    methods_->prepare();
    health_.emplace(*world_, *relations_, placed_.facts);
    if (options_.outputs)
        held_.emplace(folder_ / "restart", tools.restart_header, tools.restart_bodies, tools.state);
}

template <int Dim>
void Simulation<Dim>::begin() {
    runner_->begin();
    if (held_) held_->hold(clock());
}

template <int Dim>
void Simulation<Dim>::step() {
    runner_->step([this](const Clock& clock) {
        health_->check(clock);
        if (since_watched_.seconds() < seconds_between_watches) return;
        before_writes_();
        since_watched_.restart();
    });
    if (held_) held_->hold(clock());
}

template <int Dim>
std::optional<double> Simulation<Dim>::keepLastGoodState() {
    if (!held_) return {};
    runner_->syncOutputs();
    return held_->write();
}

template <int Dim>
io::RestartHeader Simulation<Dim>::restartHeader() const {
    io::RestartHeader header;
    header.program = programVersion();
    header.commit = programCommit();
    header.case_name = caseName(model_);
    header.case_text = physicsText(model_);
    header.digest = fmt::format("{:016x}", io::fingerprint(header.case_text));
    header.instruction_set = instructionSet();
    for (const auto& entry : provenance_.entries)
        for (const char* name : {"compiler", "flags", "processor", "threads"})
            if (entry.first == name) header.build_and_machine.entries.push_back(entry);
    header.dimension = Dim;
    return header;
}

template <int Dim>
std::vector<io::RestartBody<Dim>> Simulation<Dim>::restartBodies() const {
    auto kept = restartFields(placed_.facts);
    std::vector<io::RestartBody<Dim>> bodies;
    for (auto& body : world_->bodies) {
        if (body->isObserver()) continue;
        io::RestartBody<Dim> entry{body.get(), {}};
        for (const std::string& name : kept[body->name]) {
            // Initial values make their fields; a restart stands in for them.
            body->particles.require(*fields::find(name));
            entry.fields.push_back(name);
        }
        bodies.push_back(entry);
    }
    return bodies;
}

template <int Dim>
void Simulation<Dim>::transfer(Archive& archive) {
    {
        Section section(archive, "methods");
        methods_->transfer(archive);
    }
    Section section(archive, "loop");
    runner_->transfer(archive);
}

template <int Dim>
void Simulation<Dim>::restore() {
    if (options_.restart.empty())
        source_ = newestRestart(folder_);
    else
        source_.file = options_.restart;
    const io::RestartHeader ours = restartHeader();
    const io::RestartHeader theirs = io::readRestartHeader(source_.file);
    requireSamePhysics(source_.file, theirs, ours);
    if (theirs.instruction_set != ours.instruction_set)
        source_.warnings.push_back(fmt::format(
            "{} was written by a program for {}, this one is for {}: the last bits may differ",
            source_.file.string(), theirs.instruction_set, ours.instruction_set));
    io::readRestart<Dim>(
        source_.file, [this](Archive& archive) { transfer(archive); }, restartBodies());
    if (!options_.resume) runner_->leaveFolder();
    std::vector<bodies::Body<Dim>*> bodies;
    for (auto& body : world_->bodies) {
        body->findParts();
        ++body->version;
        bodies.push_back(body.get());
    }
    relations_->update(bodies);
}

std::string caseName(const model::Case& model) {
    std::error_code ignored;  // where there is no present folder any more
    const std::filesystem::path path =
        std::filesystem::absolute(model.path, ignored).lexically_normal();
    return path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace sphinx::run
