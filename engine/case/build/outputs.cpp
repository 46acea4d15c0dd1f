// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/outputs.h"

#include "case/build/derived_output.h"
#include "case/build/loop_facts.h"
#include "dynamics/part.h"
#include "io/output/factory.h"
#include "io/output/progress.h"
#include "io/restart/output.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>

namespace sphinx::build {
namespace {

template <int Dim>
std::unique_ptr<Output> makeRestart(const OutputTools<Dim>& tools,
                                    const io::RestartSettings& settings) {
    io::RestartParameters parameters{settings, tools.folder / "restart", tools.restart_header};
    return std::make_unique<io::RestartOutput<Dim>>(parameters, tools.restart_bodies, tools.state);
}

/// Observers whose points move.
template <int Dim>
std::vector<io::Follower<Dim>> followers(const OutputTools<Dim>& tools) {
    std::vector<io::Follower<Dim>> found;
    for (const model::Body& body : tools.model.bodies) {
        if (body.role != bodies::Role::observer || body.follows.what == model::Follows::space)
            continue;
        io::Follower<Dim>& follower = found.emplace_back(tools.world.find(body.name));
        if (body.follows.what == model::Follows::material) continue;
        const dynamics::Part<Dim> part(tools.world, body.follows.solid);
        follower.solid = &part.body();
        follower.part = part.named();
    }
    return found;
}

/// Refuses what would write the same files as an output before it.
class FileOwners {
 public:
    void add(const model::Output& source, const Output& output) {
        for (const OutputFile& file : output.files()) {
            const auto [owner, added] = owners_.emplace(file.name, source.name);
            if (!added)
                io::failAt(source.place, fmt::format("'{}' would write {}, a file of '{}'; {}",
                                                     source.name, file.name, owner->second,
                                                     "two outputs cannot write the same"));
        }
    }

 private:
    std::map<std::string, std::string> owners_;
};

}  // namespace

template <int Dim>
Outputs<Dim>::Outputs(const OutputTools<Dim>& tools, bool files) {
    const auto results =
        std::make_shared<io::ResultsFile>(tools.folder / "results.h5", tools.provenance);
    const io::OutputContext<Dim> context{
        tools.world, tools.relations, tools.folder,  tools.model.units, tools.provenance,
        results,     tools.progress,  tools.methods, tools.loads,       followers(tools)};
    FileOwners owners;
    for (const model::Output& source : tools.model.outputs) {
        const std::string& type = source.declaration->name();
        const bool restart = type == "restart";
        if (!files && type != "progress") continue;
        DerivedFields<Dim> derived(source, tools.world);
        if (restart)
            outputs_.push_back(makeRestart(tools, source.as<io::RestartSettings>()));
        else
            outputs_.push_back(withDerivedFields(
                source.declaration->builder<io::OutputFactory>().make(source, context),
                std::move(derived)));
        owners.add(source, *outputs_.back());
        entries_.push_back(
            {source.name, type, outputs_.back().get(), triggerOf(source.every), restart});
    }
    addImplied(tools, files);
}

/// What a case need not ask for, under names that no output of a case can have.
template <int Dim>
void Outputs<Dim>::addImplied(const OutputTools<Dim>& tools, bool files) {
    const auto has = [&](std::string_view type) {
        return std::ranges::any_of(entries_, [&](const auto& entry) { return entry.type == type; });
    };
    const auto every = [](double wall_seconds) {
        return loop::Trigger{loop::Trigger::Kind::wall_time, wall_seconds, {}};
    };
    if (!has("progress")) {
        outputs_.push_back(std::make_unique<io::ProgressOutput>(
            io::ProgressParameters{io::onTerminal(), tools.model.units.text(unit::time)},
            tools.progress));
        entries_.push_back({"progress of the run", "progress", outputs_.back().get(),
                            every(io::onTerminal() ? 1 : 60)});
    }
    if (files && !has("restart")) {
        outputs_.push_back(makeRestart(tools, io::RestartSettings{1, io::RestartEncoding::zlib}));
        entries_.push_back(
            {"last state", "restart", outputs_.back().get(), every(300), true, true});
    }
}

template <int Dim>
void Outputs<Dim>::addTo(loop::Plan& plan) const {
    plan.outputs = entries_;
}

template class Outputs<2>;
template class Outputs<3>;

}  // namespace sphinx::build
