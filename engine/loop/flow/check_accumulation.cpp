// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"
#include "loop/flow/zeroing.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

namespace sphinx::loop {
namespace {

struct Accumulator {
    const Layer* layer = nullptr;
    const Line* line = nullptr;
};
/// First accumulators of the layers around the present one.
using Outer = std::map<FieldKey, Accumulator>;

/// An inner layer zeroes what the outer one added.
void checkNesting(const Layer& layer, Outer outer, std::vector<Issue>& issues) {
    for (const Zeroing& zero : zeroings(layer)) {
        const auto& line = std::get<Call>(layer.steps[zero.before].value);
        const auto [other, is_new] = outer.insert({{zero.body, zero.field}, {&layer, &line}});
        if (is_new) continue;
        issues.push_back(
            {Severity::error, line.id,
             fmt::format("{} adds to {} of {} in layer {}, which zeroes it and so loses what {} "
                         "added in layer {}: call both in the same layer",
                         line.label, zero.field, zero.body, layer.name, other->second.line->label,
                         other->second.layer->name)});
    }
    for (const Step& step : layer.steps)
        if (const auto* inner = std::get_if<Layer>(&step.value))
            checkNesting(*inner, outer, issues);
}

/// The line that accumulates this field first.
const Line* firstAccumulator(const Flow& flow, const FieldKey& key) {
    for (const FlowNode& node : flow.nodes())
        if (node.line && has(*node.line, input::AccessMode::accumulate, key)) return node.line;
    return nullptr;
}

void checkUse(const Flow& flow, const Line& line, const FieldKey& key, std::vector<Issue>& issues) {
    // A reader in one of the times of the loop is enough.
    std::vector<std::size_t> after;
    for (const FlowNode& node : flow.nodes())
        if (node.line == &line) after.insert(after.end(), node.next.begin(), node.next.end());
    const auto read = [&](const FlowNode& other) { return reads(other, key); };
    const auto zeroed = [&](const FlowNode& other) {
        return other.kind == FlowNode::Kind::zero && other.zeroed == key;
    };
    if (flow.find(after, read, zeroed)) return;
    const auto zero = flow.find(after, zeroed, zeroed);
    const std::string until =
        zero ? fmt::format(" before layer {} zeroes it again", flow.nodes()[*zero].layer->name)
             : "";
    issues.push_back({Severity::warning, line.id,
                      fmt::format("{} adds to {} of {}, but nothing reads it{}", line.label,
                                  key.second, key.first, until)});
}

}  // namespace

void checkAccumulation(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    checkNesting(facts.plan.outermost, {}, issues);
    std::set<const Line*> seen;
    for (std::size_t k = 0; k < flow.nodes().size(); ++k) {
        const Line* line = flow.nodes()[k].line;
        if (!line || !seen.insert(line).second) continue;
        for (const dynamics::FieldAccess& access : line->accesses) {
            const FieldKey key{access.body, access.field};
            if (access.mode == input::AccessMode::write) {
                const Line* adding = firstAccumulator(flow, key);
                if (adding && adding != line && k > flow.loopBegins().front())
                    issues.push_back(
                        {Severity::error, line->id,
                         fmt::format("{} sets {} of {}, which {} adds to and its layer zeroes: "
                                     "only one way of writing a field can be used",
                                     line->label, key.second, key.first, adding->label)});
            }
            if (access.mode != input::AccessMode::accumulate) continue;
            if (line->every)
                issues.push_back(
                    {Severity::warning, line->id,
                     fmt::format("{} adds to {} of {} only in some steps, while its layer zeroes "
                                 "it in all of them",
                                 line->label, key.second, key.first)});
            if (!access.result) checkUse(flow, *line, key, issues);
        }
    }
}

}  // namespace sphinx::loop
