// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/build/loop.h"
#include "case/build/loop_facts.h"
#include "case/build/outputs.h"
#include "case/model/model.h"
#include "case/run/health.h"
#include "case/run/options.h"
#include "case/run/restart_source.h"
#include "core/timer.h"
#include "io/restart/held.h"
#include "loop/run/runner.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace sphinx::run {

/// "dam_break_2d" for cases/dam_break_2d/case.yaml, else the name of the file.
std::string caseName(const model::Case& model);

/// A case at work, for whoever drives it: a run, a test, another program. Use: construct;
/// prepare(); begin(); step() while it is not finished(), or less often; end(). Case and options
/// outlive it. Errors of the case are CaseError, those of the state PhysicsError, those of files
/// FileError.
template <int Dim>
class Simulation {
 public:
    /// Makes the world, unless a restart brings the particles, and the methods. `folder`: that of
    /// the results; nothing is written there yet.
    Simulation(const model::Case& model, const RunOptions& options, io::Path folder,
               io::Provenance provenance);

    /// Makes the outputs, still without writing, and reads the restart to go on from.
    void prepare();
    /// The calls of `start` and the first outputs; after a restart outputs go on.
    void begin();
    /// One outermost step, the check of its state, the outputs that are due.
    void step();
    /// The end time is reached.
    bool finished() const { return runner_->finished(); }
    /// Has it called before each substep; what it throws ends a step in its midst, after which only
    /// restarts are left.
    void watchSubsteps(const std::function<void()>& watch) { runner_->watchSubsteps(watch); }
    /// Has it called now and then after a step, and before outputs write, by the thread that does;
    /// what it throws ends the run. To be set before begin().
    void watchOutputs(std::function<void()> watch) { before_writes_ = std::move(watch); }
    /// The last outputs; of a run that is not finished its restarts only.
    void end() { runner_->end(); }
    /// After a step that failed or was ended in its midst: leaves a restart of the state of some
    /// steps before, where there is none as late. The time of the newest one; nothing without one.
    std::optional<double> keepLastGoodState();

    bool resuming() const { return options_.resume || !options_.restart.empty(); }
    const RestartSource& source() const { return source_; }  ///< when resuming
    std::string_view warnings() const { return warnings_; }
    /// How the particles of a body were fitted to its shape; empty where they were not.
    std::string arrangement(const std::string& body) const {
        const auto found = arrangements_.find(body);
        return found == arrangements_.end() ? "" : found->second;
    }
    bodies::World<Dim>& world() { return *world_; }
    /// Of the outermost layer.
    const Clock& clock() const { return runner_->clock(); }
    loop::Profile profile() const { return runner_->profile(); }
    /// Throws PhysicsError where a number is none any more.
    void checkHealth() { health_->check(clock()); }

 private:
    io::RestartHeader restartHeader() const;
    std::vector<io::RestartBody<Dim>> restartBodies() const;
    void transfer(Archive& archive);
    void restore();

    const model::Case& model_;
    const RunOptions& options_;
    io::Path folder_;
    io::Provenance provenance_;
    build::PlacedFacts placed_;
    std::string warnings_;
    std::map<std::string, std::string> arrangements_;  // by body
    RestartSource source_;
    std::unique_ptr<bodies::World<Dim>> world_;
    std::unique_ptr<neighbors::Relations<Dim>> relations_;
    std::optional<dynamics::Context<Dim>> context_;
    std::unique_ptr<build::Methods<Dim>> methods_;
    std::optional<build::Outputs<Dim>> outputs_;
    std::function<void()> before_writes_ = [] {};
    Timer since_watched_;
    std::unique_ptr<loop::Runner> runner_;
    std::optional<Health<Dim>> health_;
    std::optional<io::HeldRestart<Dim>> held_;  // with outputs
};

}  // namespace sphinx::run
