// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/simulation.h"

#include "case/build_loop.h"
#include "case/build_outputs.h"
#include "case/build_world.h"
#include "case/health.h"
#include "case/physics_text.h"
#include "case/provenance.h"
#include "case/restart_fields.h"
#include "case/show.h"
#include "case/signals.h"
#include "core/errors.h"
#include "core/log.h"
#include "core/parallel.h"
#include "io/compress.h"
#include "io/output_folder.h"
#include "io/progress.h"
#include "io/vtu.h"
#include "loop/runner.h"

#include <fmt/format.h>
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
        Context<Dim> context{*world_, *relations_};
        methods_ = std::make_unique<Methods<Dim>>(model, context);
    }

    bool resuming() const { return options_.resume || !options_.restart.empty(); }
    const std::string& warnings() const { return warnings_; }

    int run(const io::Provenance& provenance) {
        loop::Plan plan = buildPlan<Dim>(model_, placed_.facts, *world_, *methods_);
        OutputTools<Dim> tools{model_,          *world_,
                               *relations_,     folder_,
                               provenance,      [this] { return runner_->progress(); },
                               methods_->all(), restartHeader(),
                               restartBodies(), [this](Archive& archive) { transfer(archive); }};
        Outputs<Dim> outputs(tools, options_.outputs);
        outputs.addTo(plan);
        runner_ = std::make_unique<loop::Runner>(std::move(plan));
        if (resuming()) restore();
        logBodies();

        Health<Dim> health(*world_, placed_.facts);
        SignalGuard signals;
        Timer wall;
        try {
            const loop::Outcome outcome = runner_->run([&](const Clock& clock) {
                health.check(clock);
                return reasonToStop(wall);
            });
            finish(outcome);
        } catch (const PhysicsError&) {
            writeFailedState(provenance);
            throw;
        }
        return SignalGuard::received() ? 128 + SignalGuard::received() : exit_done;
    }

 private:
    std::optional<std::string> reasonToStop(const Timer& wall) const {
        switch (SignalGuard::received()) {
            case SIGINT: return "interrupted";
            case SIGTERM: return "told to end";
            default: break;
        }
        if (options_.time_limit && wall.seconds() > *options_.time_limit)
            return fmt::format("the time limit of {:g} s is over", *options_.time_limit);
        return {};
    }

    void finish(const loop::Outcome& outcome) {
        const loop::Profile profile = runner_->profile();
        for (const std::string& line : loop::profileTable(profile)) log::info(line);
        if (options_.outputs) loop::writeProfile(profile, folder_ / "profile.json");
        if (outcome.finished)
            log::info(fmt::format("done at time {:g}; results are in {}", runner_->clock().time,
                                  folder_.string()));
        else
            log::info(fmt::format("stopped at time {:g}: {}; go on with --resume",
                                  runner_->clock().time, outcome.reason));
    }

    void logBodies() const {
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
        header.dimension = Dim;
        return header;
    }

    std::vector<io::RestartBody<Dim>> restartBodies() const {
        auto kept = restartFields(placed_.facts);
        std::vector<io::RestartBody<Dim>> bodies;
        for (const auto& body : world_->bodies) {
            if (body->kind == BodyKind::observer) continue;
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
        io::Path file = options_.restart;
        if (file.empty()) {
            const io::RestartSearch search = io::findNewestValid(folder_ / "restart");
            for (const auto& [path, why] : search.skipped)
                log::warning(fmt::format("skipped {}: {}", path.string(), why));
            if (search.found.empty())
                throw FileError("no valid restart in " + (folder_ / "restart").string());
            file = search.found;
        }
        const io::RestartHeader ours = restartHeader();
        const io::RestartHeader theirs = io::readRestartHeader(file);
        if (theirs.digest != ours.digest || theirs.dimension != Dim)
            throw CaseError(fmt::format(
                "error: the case is not the one that {} was written by; only title, outputs and "
                "loop.end_time may change:\n{}",
                file.string(), difference(theirs.case_text, ours.case_text, 20)));
        if (theirs.instruction_set != ours.instruction_set)
            log::warning(
                fmt::format("{} was written by a program for {}, this one is for {}: the "
                            "last bits may differ",
                            file.string(), theirs.instruction_set, ours.instruction_set));
        io::readRestart<Dim>(
            file, [this](Archive& archive) { transfer(archive); }, restartBodies());
        std::vector<sphinx::Body<Dim>*> bodies;
        for (const auto& body : world_->bodies) {
            ++body->version;
            bodies.push_back(body.get());
        }
        relations_->update(bodies);
        log::info(
            fmt::format("going on from {} at time {:g}", file.string(), runner_->clock().time));
    }

    /// For inspection; the last good restart stays as it is.
    void writeFailedState(const io::Provenance& provenance) {
        if (!options_.outputs) return;
        const io::Path folder = folder_ / "failed";
        io::makeFolder(folder);
        std::vector<io::BodyFrames<Dim>> frames;
        for (const auto& body : world_->bodies) {
            if (body->kind == BodyKind::observer) continue;
            io::BodyFrames<Dim> f{body.get(), {}};
            for (const auto& field : body->particles.all())
                if (field->info().name != "position") f.fields.emplace_back(field->info().name);
            frames.push_back(f);
        }
        io::VtuOutput<Dim>({folder, false, model_.units, provenance}, frames)
            .write(runner_->clock());
        log::info("the state is in " + folder.string());
    }

    const Case& model_;
    const RunOptions& options_;
    io::Path folder_;
    PlacedFacts placed_;
    std::string warnings_;
    std::unique_ptr<World<Dim>> world_;
    std::unique_ptr<Relations<Dim>> relations_;
    std::unique_ptr<Methods<Dim>> methods_;
    std::unique_ptr<loop::Runner> runner_;
};

template <int Dim>
int run(const Case& model, const RunOptions& options) {
    const bool resuming = options.resume || !options.restart.empty();
    const io::Path path =
        options.output.empty() ? io::Path("output") / caseName(model) : io::Path(options.output);
    Simulation<Dim> simulation(model, options, path);

    std::optional<io::OutputFolder> folder;
    if (options.outputs) {
        folder.emplace(path, options.resume      ? io::ExistingResults::keep
                             : options.overwrite ? io::ExistingResults::replace
                                                 : io::ExistingResults::refuse);
        log::openFile(path / "log.txt");
        io::writeFileAtomically(path / io::resolved_case_name, showCase(model));
    }
    const io::Provenance provenance = makeProvenance(threadCount());
    for (const auto& [name, value] : provenance.entries) log::fileOnly(name + ": " + value);
    log::info(fmt::format("{}{}", model.title.empty() ? caseName(model) : model.title,
                          resuming ? ", resumed" : ""));
    for (const std::string& text : {model.warnings, simulation.warnings()})
        if (!text.empty()) log::warning(text);
    const int code = simulation.run(provenance);
    log::closeFile();
    return code;
}

}  // namespace

std::string caseName(const Case& model) {
    const std::filesystem::path path = std::filesystem::absolute(model.path);
    return path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
}

int runCase(const Case& model, const RunOptions& options) {
    setThreadCount(options.threads);
    return model.dimension == 2 ? run<2>(model, options) : run<3>(model, options);
}

}  // namespace sphinx::model
