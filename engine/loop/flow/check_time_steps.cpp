// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <algorithm>

namespace sphinx::loop {
namespace {

/// `may_extend`: whether the layer's interval may become longer than planned.
void checkInside(const Layer& layer, bool may_extend, std::vector<Issue>& issues) {
    const Layer* first = nullptr;
    for (const Step& step : layer.steps) {
        const auto* inner = std::get_if<Layer>(&step.value);
        if (!inner) continue;
        if (inner->dt.empty() && !inner->fixed_dt)
            issues.push_back({Severity::error, inner->id,
                              fmt::format("layer {} has no time step: give it a dt", inner->name)});
        const bool overshoots = inner->fit == Fit::overshoot;
        if (overshoots && !may_extend)
            issues.push_back(
                {Severity::error, inner->id,
                 fmt::format("layer {} overshoots, but the layer {} around it has to end at a "
                             "given time: give that layer fit: overshoot as well",
                             inner->name, layer.name)});
        if (overshoots && first)
            issues.push_back(
                {Severity::error, inner->id,
                 fmt::format("layer {} overshoots and would leave layer {} behind, which has "
                             "covered the same step before it: put {} first",
                             inner->name, first->name, inner->name)});
        if (!first) first = inner;
        checkInside(*inner, overshoots, issues);
    }
}

}  // namespace

void checkTimeSteps(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    const Layer& outermost = facts.plan.outermost;
    if (outermost.dt.empty() && !outermost.fixed_dt)
        issues.push_back(
            {Severity::error, outermost.id,
             fmt::format("the loop has no time step: give layer {} a dt", outermost.name)});
    checkInside(outermost, true, issues);

    for (const BodyFacts& body : facts.bodies) {
        const FieldKey position{body.name, "position"};
        const bool moved =
            std::any_of(flow.nodes().begin(), flow.nodes().end(), [&](const FlowNode& node) {
                return node.line && has(*node.line, input::AccessMode::write, position);
            });
        if (body.moves && !moved)
            issues.push_back({Severity::warning, outermost.id,
                              fmt::format("{} never moves: no line of the loop writes its position",
                                          body.name)});
    }
}

}  // namespace sphinx::loop
