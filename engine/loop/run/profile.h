// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/run/layer_run.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sphinx::loop {

/// What one line of the loop has cost. A layer's time includes its lines.
struct ProfileLine {
    std::string label;
    std::string kind;        ///< layer, call, time_step, checks, start, output, writing
    std::int64_t calls = 0;  ///< of a layer: substeps
    double seconds = 0;      ///< wall clock
    std::optional<double> nanoseconds_per_particle;  ///< nothing for lines without particles
    double share = 0;                                ///< of loop_seconds
    std::vector<ProfileLine> lines;
    std::int64_t iterations = 0;  ///< of a solver, in all calls
};

/// Cost of this process's part of a run, in the shape of its loop.
struct Profile {
    double time = 0;             ///< where the run stands, case units
    bool finished = false;       ///< the end time was reached
    double loop_seconds = 0;     ///< outermost steps and the checks after them, without outputs
    double start_seconds = 0;    ///< start lines
    double output_seconds = 0;   ///< outputs: sampling, and taking what is to be written
    double writing_seconds = 0;  ///< writing it, by another thread
    std::vector<std::pair<std::string, std::int64_t>> steps;  ///< by layer, from the outermost
    std::vector<ProfileLine> lines;                           ///< the outermost layer; the checks
    std::vector<ProfileLine> start;
    std::vector<ProfileLine> outputs;
    std::vector<ProfileLine> writing;
};

/// A line from its tally, without share.
ProfileLine profileLine(std::string label, std::string kind, const Tally& tally);
/// A layer with all inside it, without shares; appends its steps and those of inner layers.
ProfileLine profileLayer(const LayerRun& layer,
                         std::vector<std::pair<std::string, std::int64_t>>& steps);
/// Sets all shares from loop_seconds.
void setShares(Profile& profile);

/// A table for the log, a string for each line.
std::vector<std::string> profileTable(const Profile& profile);
/// {"time": t, "finished": true, "loop_seconds": s, ..., "steps": {LAYER: n}, "lines": [...],
/// "start": [...], "outputs": [...], "writing": [...]}; a line is {"label", "kind", "calls",
/// "seconds", "ns_per_particle" or null, "share", "lines"}, and where it solves something
/// "iterations" in all its calls.
std::string profileJson(const Profile& profile);
/// Writes profileJson(). Throws FileError.
void writeProfile(const Profile& profile, const std::filesystem::path& path);

}  // namespace sphinx::loop
