// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/run/profile.h"

#include <fmt/format.h>

#include <algorithm>

namespace sphinx::loop {

ProfileLine profileLine(std::string label, std::string kind, const Tally& tally) {
    ProfileLine line;
    line.label = std::move(label);
    line.kind = std::move(kind);
    line.calls = tally.calls;
    line.seconds = tally.seconds();
    if (tally.particles > 0)
        line.nanoseconds_per_particle = static_cast<double>(tally.nanoseconds) / tally.particles;
    return line;
}

ProfileLine profileLayer(const LayerRun& layer,
                         std::vector<std::pair<std::string, std::int64_t>>& steps) {
    ProfileLine whole = profileLine(layer.layer().name, "layer", layer.tally());
    steps.emplace_back(whole.label, whole.calls);
    for (std::size_t k = 0; k < layer.layer().dt.size(); ++k)
        whole.lines.push_back(
            profileLine(layer.layer().dt[k].label, "time_step", layer.estimateTallies()[k]));
    for (const LayerRun::Line& line : layer.lines()) {
        if (const auto* call = std::get_if<LayerRun::CallRun>(&line)) {
            whole.lines.push_back(profileLine(call->call->label, "call", call->tally));
            whole.lines.back().iterations = call->call->method->iterations();
        } else {
            whole.lines.push_back(profileLayer(*std::get<std::unique_ptr<LayerRun>>(line), steps));
        }
    }
    return whole;
}

namespace {

void setShares(std::vector<ProfileLine>& lines, double whole) {
    for (ProfileLine& line : lines) {
        line.share = whole > 0 ? line.seconds / whole : 0;
        setShares(line.lines, whole);
    }
}

struct Row {
    std::string label;
    const ProfileLine* line;
};

void collectRows(const std::vector<ProfileLine>& lines, std::size_t depth, std::vector<Row>& rows) {
    for (const ProfileLine& line : lines) {
        const std::string kind = line.kind == "time_step" ? "dt: " : "";
        rows.push_back({std::string(2 * depth, ' ') + kind + line.label, &line});
        collectRows(line.lines, depth + 1, rows);
    }
}

}  // namespace

void setShares(Profile& profile) {
    for (auto* lines : {&profile.lines, &profile.start, &profile.outputs, &profile.writing})
        setShares(*lines, profile.loop_seconds);
}

std::vector<std::string> profileTable(const Profile& profile) {
    std::vector<Row> loop, start, outputs, writing;
    collectRows(profile.lines, 0, loop);
    collectRows(profile.start, 1, start);
    collectRows(profile.outputs, 1, outputs);
    collectRows(profile.writing, 1, writing);
    std::size_t width = 24;
    for (const auto* rows : {&loop, &start, &outputs, &writing})
        for (const Row& row : *rows) width = std::max(width, row.label.size());

    std::vector<std::string> table;
    table.push_back(fmt::format("{:<{}}  {:>10}  {:>11}  {:>11}  {:>7}", "profile", width, "calls",
                                "seconds", "ns/particle", "share"));
    const auto add = [&](const Row& row) {
        const auto& cost = row.line->nanoseconds_per_particle;
        table.push_back(fmt::format(
            "{:<{}}  {:>10}  {:>11.3f}  {:>11}  {:>6.1f}%", row.label, width, row.line->calls,
            row.line->seconds, cost ? fmt::format("{:.1f}", *cost) : "", 100 * row.line->share));
        if (row.line->iterations > 0 && row.line->calls > 0)
            table.back() += fmt::format(
                "  {:.1f} iterations a call",
                static_cast<double>(row.line->iterations) / static_cast<double>(row.line->calls));
    };
    for (const Row& row : loop) add(row);
    const auto addGroup = [&](const char* title, double seconds, const std::vector<Row>& rows) {
        if (rows.empty()) return;
        table.push_back(fmt::format("{:<{}}  {:>10}  {:>11.3f}", title, width, "", seconds));
        for (const Row& row : rows) add(row);
    };
    addGroup("start", profile.start_seconds, start);
    addGroup("outputs", profile.output_seconds, outputs);
    addGroup("writing them meanwhile", profile.writing_seconds, writing);
    return table;
}

}  // namespace sphinx::loop
