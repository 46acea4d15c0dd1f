// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "core/progress.h"
#include "dynamics/context.h"
#include "io/file/provenance.h"
#include "io/restart/restart.h"
#include "loop/plan/plan.h"
#include "neighbors/relations.h"

#include <functional>
#include <memory>
#include <vector>

namespace sphinx::build {

/// What the outputs of a case are made from.
template <int Dim>
struct OutputTools {
    const model::Case& model;
    bodies::World<Dim>& world;
    neighbors::Relations<Dim>& relations;
    io::Path folder;
    io::Provenance provenance;
    std::function<Progress()> progress;
    std::vector<const dynamics::Method*> methods;               ///< those of the loop
    std::vector<const dynamics::fluid::SolidLoad<Dim>*> loads;  ///< theirs
    io::RestartHeader restart_header;
    std::vector<io::RestartBody<Dim>> restart_bodies;
    io::StateTransfer state;
};

/// The outputs of a case.
template <int Dim>
class Outputs {
 public:
    /// Without `files` only those that write no file (progress) are made. Nothing is written yet.
    /// Throws CaseError with its place for an output that asks for what the bodies do not have, or
    /// that would write the files of another.
    Outputs(const OutputTools<Dim>& tools, bool files);

    void addTo(loop::Plan& plan) const;
    /// In the order of the case; then, where it has none, one that tells of the progress and one
    /// that keeps the last state.
    const std::vector<loop::OutputEntry>& entries() const { return entries_; }

 private:
    void addImplied(const OutputTools<Dim>& tools, bool files);

    std::vector<std::unique_ptr<Output>> outputs_;
    std::vector<loop::OutputEntry> entries_;
};

}  // namespace sphinx::build
