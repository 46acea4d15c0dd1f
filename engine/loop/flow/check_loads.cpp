// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace sphinx::loop {
namespace {

/// Of one fluid: whether the viscous force that it feels is that of its present velocity.
struct LoadState {
    bool fresh = false;
    const LineFacts* cause = nullptr;  ///< the line that made it stale; null: never computed
};
using LoadStates = std::map<std::string, LoadState>;  ///< by fluid

FieldKey loadOf(const std::string& fluid) {
    return {fluid, std::string(pseudo_field::fresh_viscous_load)};
}

class LoadCheck {
 public:
    LoadCheck(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues)
        : facts_(facts), flow_(flow), issues_(issues) {}

    void run() {
        LoadStates initial;
        for (const BodyFacts& body : facts_.bodies) initial[body.name];
        const std::vector<LoadStates> before = solveForward(flow_, initial, act, meet);
        for (std::size_t k = 0; k < flow_.nodes().size(); ++k)
            if (const LineFacts* line = flow_.nodes()[k].line)
                for (const auto& [fluid, state] : before[k])
                    if (has(*line, AccessMode::read, loadOf(fluid)) && !state.fresh)
                        report(flow_.nodes()[k], fluid, state);
    }

 private:
    static void act(const FlowNode& node, LoadStates& states) {
        if (!node.line) return;
        for (auto& [fluid, state] : states) {
            if (state.fresh && has(*node.line, AccessMode::write, {fluid, "velocity"}))
                state = {false, node.line};
            if (!node.line->sometimes && has(*node.line, AccessMode::write, loadOf(fluid)))
                state = {true, nullptr};
        }
    }
    static bool meet(LoadStates& into, const LoadStates& from) {
        bool changed = false;
        for (auto& [fluid, state] : into) {
            const LoadState& other = from.at(fluid);
            if (!state.fresh || other.fresh) continue;
            state = other;
            changed = true;
        }
        return changed;
    }

    void report(const FlowNode& node, const std::string& fluid, const LoadState& state) {
        const LineFacts& line = *node.line;
        if (!reported_.insert(line.id).second) return;
        const std::string what =
            fmt::format("{} hands on the viscous force that {} has felt", line.label, fluid);
        const LineFacts* writer = nullptr;
        for (const FlowNode& node : flow_.nodes())
            if (!writer && node.line && has(*node.line, AccessMode::write, loadOf(fluid)))
                writer = node.line;
        if (!writer)
            issues_.push_back(
                {Severity::error, line.id,
                 fmt::format("{}, but no line computes it: call a method of type {} for {} first",
                             what, makers(), fluid)});
        else if (state.cause)
            issues_.push_back(
                {Severity::error, line.id,
                 fmt::format("{}, but {} has changed its velocity since: call {} directly after {}",
                             what, state.cause->label, line.label, writer->label)});
        else
            issues_.push_back({Severity::error, line.id,
                               fmt::format("{}, but{} {} has not computed it yet: call {} directly "
                                           "after {}",
                                           what, flow_.epochText(node.epoch), writer->label,
                                           line.label, writer->label)});
    }
    std::string makers() const {
        std::string names;
        for (const FieldMaker& maker : facts_.makers)
            if (maker.fields.count(std::string(pseudo_field::fresh_viscous_load)) > 0)
                names += (names.empty() ? "" : " or ") + maker.method;
        return names;
    }

    const LoopFacts& facts_;
    const Flow& flow_;
    std::vector<Issue>& issues_;
    std::set<int> reported_;
};

}  // namespace

void checkLoads(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    LoadCheck(facts, flow, issues).run();
}

}  // namespace sphinx::loop
