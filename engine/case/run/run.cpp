// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/run.h"

#include "case/run/failed_state.h"
#include "case/run/provenance.h"
#include "case/run/restart_source.h"
#include "case/run/show.h"
#include "case/run/signals.h"
#include "case/run/simulation.h"
#include "core/errors.h"
#include "core/log.h"
#include "core/parallel.h"
#include "io/output/folder.h"

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>
#include <new>

namespace sphinx::run {
namespace {

/// The step under way takes too long for what wants to end the run.
struct StoppedWithinStep {
    std::string why;
};
/// Steps that end by themselves within this time leave a restart.
constexpr double patience = 5;  // seconds

/// Drives a simulation to its end, or to where a signal or the time limit stops it, and tells of
/// it.
template <int Dim>
class Run {
 public:
    Run(const model::Case& model, const RunOptions& options, const io::Path& folder,
        const io::Provenance& provenance)
        : model_(model),
          options_(options),
          folder_(folder),
          provenance_(provenance),
          simulation_(model, options, folder, provenance) {}

    Simulation<Dim>& simulation() { return simulation_; }

    /// The exit code.
    int toTheEnd() {
        logStart();
        const Timer wall;
        try {
            simulation_.watchSubsteps([&] { losePatience(wall); });
            simulation_.begin();
            std::optional<std::string> stop = signalName();
            while (!simulation_.finished() && !stop) {
                simulation_.step();
                stop = reasonToStop(wall);
            }
            simulation_.end();
            finish(stop);
            // A signal that came too late, while the last files were written, stopped nothing.
            if (simulation_.finished()) return exit_done;
        } catch (const StoppedWithinStep& stopped) {
            log::info(
                fmt::format("stopped within the step from time {}, of which no end was in "
                            "sight: {}",
                            timeText(), stopped.why));
            keepLastGoodState();
        } catch (const PhysicsError&) {
            writeFailedState();
            keepLastGoodState();
            // A number that is none any more is the reason, whoever stumbled over it first.
            simulation_.checkHealth();
            throw;
        } catch (const std::bad_alloc&) {
            room_to_tell_.reset();
            throw FileError(
                fmt::format("no memory is left at time {}; restarts stay as they are", timeText()));
        }
        return SignalGuard::received() ? 128 + SignalGuard::received() : exit_done;
    }

 private:
    static std::optional<std::string> signalName() {
        switch (SignalGuard::received()) {
            case 0: return {};
            case SIGINT: return "interrupted";
            case SIGHUP: return "its terminal has gone";
            case SIGXCPU: return "the limit of processor time is reached";
            default: return "told to end";
        }
    }

    std::optional<std::string> reasonToStop(const Timer& wall) const {
        if (auto signal = signalName()) return signal;
        if (options_.time_limit && wall.seconds() > *options_.time_limit)
            return fmt::format("the time limit of {:g} s is over", *options_.time_limit);
        return {};
    }

    /// Asked before each substep: some steps have millions of them.
    void losePatience(const Timer& wall) {
        const std::optional<std::string> why = reasonToStop(wall);
        if (!why) return;
        if (!asked_to_stop_)
            asked_to_stop_ = wall.seconds();
        else if (wall.seconds() > *asked_to_stop_ + patience)
            throw StoppedWithinStep{*why};
    }

    void finish(const std::optional<std::string>& stop) {
        tellRemoved();
        const loop::Profile profile = simulation_.profile();
        for (const std::string& line : loop::profileTable(profile)) log::info(line);
        if (options_.outputs) loop::writeProfile(profile, folder_ / "profile.json");
        if (simulation_.finished())
            log::info(fmt::format(
                "done at time {}{}", timeText(),
                options_.outputs ? "; results are in " + folder_.string() : std::string()));
        else
            log::info(fmt::format(
                "stopped at time {}: {}; {}", timeText(), *stop,
                options_.outputs ? "go on with --resume" : "without outputs there is no restart"));
    }

    std::string timeText() { return world().quantityText(simulation_.clock().time, unit::time); }

    /// Particles that lost_particles: remove took since the first start of the run.
    void tellRemoved() {
        for (const auto& body : world().bodies) {
            const particles::ParticleSet<Dim>& particles = body->particles;
            const auto removed = particles.nextId() - static_cast<std::int64_t>(particles.size());
            if (removed > 0)
                log::info(fmt::format("{}: {} particles left the domain and were removed",
                                      body->name, removed));
        }
    }

    void logStart() {
        for (const std::string& line : simulation_.source().warnings) log::warning(line);
        if (simulation_.resuming())
            log::info(fmt::format("going on from {} at time {}", simulation_.source().file.string(),
                                  timeText()));
        for (const auto& body : world().bodies) {
            const std::string arrangement = simulation_.arrangement(body->name);
            log::info(fmt::format("{}: {} particles{}{}", body->name, body->size(),
                                  arrangement.empty() ? "" : ", ", arrangement));
        }
    }

    void keepLastGoodState() {
        try {
            if (const auto time = simulation_.keepLastGoodState())
                log::info(fmt::format("the state of time {} is kept: --resume goes on from it",
                                      world().quantityText(*time, unit::time)));
        } catch (const FileError& e) {
            log::warning(fmt::format("the last good state is not kept: {}", e.what()));
        }
    }

    /// For inspection: not the state to go on from.
    void writeFailedState() {
        if (!options_.outputs) return;
        const io::Path folder = folder_ / "failed";
        try {
            run::writeFailedState(world(), simulation_.clock(),
                                  {folder, false, model_.units, provenance_});
            log::info("the state is in " + folder.string());
        } catch (const FileError& e) {
            // What went wrong first is what the user must hear of.
            log::warning(fmt::format("no state for inspection: {}", e.what()));
        }
    }

    bodies::World<Dim>& world() { return simulation_.world(); }

    const model::Case& model_;
    const RunOptions& options_;
    const io::Path& folder_;
    const io::Provenance& provenance_;
    Simulation<Dim> simulation_;
    std::optional<double> asked_to_stop_;  // wall time
    /// Given up when no memory is left: to say so takes some.
    std::unique_ptr<char[]> room_to_tell_ = std::make_unique<char[]>(1 << 14);
};

std::vector<io::Path> filesRead(const model::Case& model, const RunOptions& options) {
    std::vector<io::Path> files(model.sources.begin(), model.sources.end());
    for (const auto& [path, content] : model.files) files.emplace_back(path);
    if (!options.restart.empty()) files.emplace_back(options.restart);
    return files;
}

template <int Dim>
int runIn(const model::Case& model, const RunOptions& options) {
    const io::Path path =
        options.output.empty() ? io::Path("output") / caseName(model) : io::Path(options.output);
    const io::Provenance provenance = makeProvenance(threadCount());
    SignalGuard signals;
    std::optional<io::OutputFolder> folder;  // outlives what writes into it
    Run<Dim> run(model, options, path, provenance);
    Simulation<Dim>& simulation = run.simulation();

    // A folder to go on in is locked before its restarts are read. Any other one changes only when
    // the case and the restart are known to be good.
    if (options.resume && options.outputs && io::isFolder(path))
        folder.emplace(path, io::ExistingResults::keep);
    simulation.prepare();
    signals.remember();
    if (options.outputs) {
        if (options.overwrite) requireOutside(filesRead(model, options), path);
        if (!folder)
            folder.emplace(path, options.overwrite ? io::ExistingResults::replace
                                                   : io::ExistingResults::refuse);
        io::writeFileAtomically(path / io::resolved_case_name, showCase(model));
        log::openFile(path / "log.txt");
        simulation.watchOutputs([&folder] { folder->requireInPlace(); });
    }
    for (const auto& [name, value] : provenance.entries) log::fileOnly(name + ": " + value);
    log::info(fmt::format("{}{}", model.title.empty() ? caseName(model) : model.title,
                          simulation.resuming() ? ", resumed" : ""));
    for (const std::string_view text : {std::string_view(model.warnings), simulation.warnings()})
        if (!text.empty()) log::message(text.substr(0, text.size() - 1));
    const auto toTheEnd = [&] {
        try {
            return run.toTheEnd();
        } catch (const FileError&) {
            if (folder) folder->requireInPlace();  // else that is the reason
            throw;
        }
    };
    try {
        const int code = toTheEnd();
        log::closeFile();
        return code;
    } catch (const std::exception& e) {
        log::fileOnly(std::string("error: ") + e.what());
        throw;
    }
}

}  // namespace

int runCase(const model::Case& model, const RunOptions& options) {
    setThreadCount(options.threads);
    return model.dimension == 2 ? runIn<2>(model, options) : runIn<3>(model, options);
}

}  // namespace sphinx::run
