// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/simulation.h"

#include "case/build/loop.h"
#include "case/build/outputs.h"
#include "case/build/world.h"
#include "case/run/failed_state.h"
#include "case/run/health.h"
#include "case/run/physics_text.h"
#include "case/run/provenance.h"
#include "case/run/restart_fields.h"
#include "case/run/restart_source.h"
#include "case/run/show.h"
#include "case/run/signals.h"
#include "core/errors.h"
#include "core/log.h"
#include "core/parallel.h"
#include "io/file/compress.h"
#include "io/output/folder.h"
#include "io/output/progress.h"
#include "loop/run/runner.h"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <filesystem>

namespace sphinx::model {
namespace {

template <int Dim>
class Simulation {
 public:
    Simulation(const Case& model, const RunOptions& options, const io::Path& folder)
        : model_(model), options_(options), folder_(folder), placed_(loopFacts(model)) {
        input::Diagnostics diagnostics;
        checkLoop(placed_, diagnostics);
        diagnostics.throwIfErrors();
        world_ = buildWorld<Dim>(model, !resuming(), diagnostics);
        diagnostics.throwIfErrors();
        warnings_ = diagnostics.text();
        relations_ = std::make_unique<Relations<Dim>>(*world_);
        context_.emplace(Context<Dim>{*world_, *relations_});
        methods_ = std::make_unique<Methods<Dim>>(model, *context_);
    }

    bool resuming() const { return options_.resume || !options_.restart.empty(); }
    std::string_view warnings() const { return warnings_; }

    /// Everything up to the first step, without touching the results folder; a restart is read.
    void prepare(const io::Provenance& provenance) {
        provenance_ = provenance;
        loop::Plan plan = buildPlan<Dim>(model_, placed_.facts, *world_, *methods_);
        const OutputTools<Dim> tools{
            model_,          *world_,
            *relations_,     folder_,
            provenance_,     [this] { return runner_->progress(); },
            methods_->all(), restartHeader(),
            restartBodies(), [this](Archive& archive) { transfer(archive); }};
        outputs_.emplace(tools, options_.outputs);
        outputs_->addTo(plan);
        runner_ = std::make_unique<loop::Runner>(std::move(plan));
        if (resuming()) restore();
        methods_->prepare();
    }

    int run() {
        logStart();
        Health<Dim> health(*world_, placed_.facts);
        Timer wall;
        try {
            const auto after_step = [&](const Clock& clock) {
                health.check(clock);
                return reasonToStop(wall);
            };
            const loop::Outcome outcome = runner_->run(after_step, [&] { return signalName(); });
            finish(outcome);
            // One that came too late, while the last files were written, stopped nothing.
            if (outcome.finished) return exit_done;
        } catch (const PhysicsError&) {
            writeFailedState();
            // A number that is none any more is the reason, whoever stumbled over it first.
            health.check(runner_->clock());
            throw;
        }
        return SignalGuard::received() ? 128 + SignalGuard::received() : exit_done;
    }

 private:
    static std::optional<std::string> signalName() {
        switch (SignalGuard::received()) {
            case SIGINT: return "interrupted";
            case SIGTERM: return "told to end";
            default: return {};
        }
    }

    std::optional<std::string> reasonToStop(const Timer& wall) const {
        if (auto signal = signalName()) return signal;
        if (options_.time_limit && wall.seconds() > *options_.time_limit)
            return fmt::format("the time limit of {:g} s is over", *options_.time_limit);
        return {};
    }

    void finish(const loop::Outcome& outcome) {
        tellRemoved();
        const loop::Profile profile = runner_->profile();
        for (const std::string& line : loop::profileTable(profile)) log::info(line);
        if (options_.outputs) loop::writeProfile(profile, folder_ / "profile.json");
        if (outcome.finished)
            log::info(fmt::format(
                "done at time {}{}", timeText(),
                options_.outputs ? "; results are in " + folder_.string() : std::string()));
        else
            log::info(fmt::format(
                "stopped at time {}: {}; {}", timeText(), outcome.reason,
                options_.outputs ? "go on with --resume" : "without outputs there is no restart"));
    }

    std::string timeText() const { return world_->quantityText(runner_->clock().time, unit::time); }

    /// Particles that lost_particles: remove took since the first start of the run.
    void tellRemoved() const {
        for (const auto& body : world_->bodies) {
            const ParticleSet<Dim>& particles = body->particles;
            const auto removed = particles.nextId() - static_cast<std::int64_t>(particles.size());
            if (removed > 0)
                log::info(fmt::format("{}: {} particles left the domain and were removed",
                                      body->name, removed));
        }
    }

    void logStart() const {
        for (const std::string& line : source_.warnings) log::warning(line);
        if (resuming())
            log::info(
                fmt::format("going on from {} at time {}", source_.file.string(), timeText()));
        for (const auto& body : world_->bodies)
            log::info(fmt::format("{}: {} particles", body->name, body->size()));
    }

    io::RestartHeader restartHeader() const {
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

    std::vector<io::RestartBody<Dim>> restartBodies() const {
        auto kept = restartFields(placed_.facts);
        std::vector<io::RestartBody<Dim>> bodies;
        for (const auto& body : world_->bodies) {
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

    void transfer(Archive& archive) {
        {
            Section section(archive, "methods");
            methods_->transfer(archive);
        }
        Section section(archive, "loop");
        runner_->transfer(archive);
    }

    void restore() {
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
        if (!options_.resume) runner_->leaveRestarts();
        std::vector<sphinx::Body<Dim>*> bodies;
        for (const auto& body : world_->bodies) {
            body->findParts();
            ++body->version;
            bodies.push_back(body.get());
        }
        relations_->update(bodies);
    }

    /// For inspection; the last good restart stays as it is.
    void writeFailedState() const {
        if (!options_.outputs) return;
        const io::Path folder = folder_ / "failed";
        try {
            model::writeFailedState(*world_, runner_->clock(),
                                    {folder, false, model_.units, provenance_});
            log::info("the state is in " + folder.string());
        } catch (const FileError& e) {
            // What went wrong first is what the user must hear of.
            log::warning(fmt::format("no state for inspection: {}", e.what()));
        }
    }

    const Case& model_;
    const RunOptions& options_;
    io::Path folder_;
    PlacedFacts placed_;
    std::string warnings_;
    io::Provenance provenance_;
    RestartSource source_;
    std::unique_ptr<World<Dim>> world_;
    std::unique_ptr<Relations<Dim>> relations_;
    std::optional<Context<Dim>> context_;
    std::unique_ptr<Methods<Dim>> methods_;
    std::optional<Outputs<Dim>> outputs_;
    std::unique_ptr<loop::Runner> runner_;
};

std::vector<io::Path> filesRead(const Case& model, const RunOptions& options) {
    std::vector<io::Path> files(model.sources.begin(), model.sources.end());
    for (const auto& [path, content] : model.files) files.emplace_back(path);
    if (!options.restart.empty()) files.emplace_back(options.restart);
    return files;
}

template <int Dim>
int run(const Case& model, const RunOptions& options) {
    const io::Path path =
        options.output.empty() ? io::Path("output") / caseName(model) : io::Path(options.output);
    const io::Provenance provenance = makeProvenance(threadCount());
    SignalGuard signals;
    Simulation<Dim> simulation(model, options, path);

    // A folder to go on in is locked before its restarts are read. Any other one changes only when
    // the case and the restart are known to be good.
    std::optional<io::OutputFolder> folder;
    if (options.resume && options.outputs && io::isFolder(path))
        folder.emplace(path, io::ExistingResults::keep);
    simulation.prepare(provenance);
    signals.remember();
    if (options.outputs) {
        if (options.overwrite) requireOutside(filesRead(model, options), path);
        if (!folder)
            folder.emplace(path, options.overwrite ? io::ExistingResults::replace
                                                   : io::ExistingResults::refuse);
        io::writeFileAtomically(path / io::resolved_case_name, showCase(model));
        log::openFile(path / "log.txt");
    }
    for (const auto& [name, value] : provenance.entries) log::fileOnly(name + ": " + value);
    log::info(fmt::format("{}{}", model.title.empty() ? caseName(model) : model.title,
                          simulation.resuming() ? ", resumed" : ""));
    for (const std::string_view text : {std::string_view(model.warnings), simulation.warnings()})
        if (!text.empty()) log::message(text.substr(0, text.size() - 1));
    try {
        const int code = simulation.run();
        log::closeFile();
        return code;
    } catch (const std::exception& e) {
        log::fileOnly(std::string("error: ") + e.what());
        throw;
    }
}

}  // namespace

std::string caseName(const Case& model) {
    std::error_code ignored;  // where there is no present folder any more
    const std::filesystem::path path = std::filesystem::absolute(model.path, ignored);
    return path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
}

int runCase(const Case& model, const RunOptions& options) {
    setThreadCount(options.threads);
    return model.dimension == 2 ? run<2>(model, options) : run<3>(model, options);
}

}  // namespace sphinx::model
