// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace sphinx::loop {
namespace {

/// Of one fluid: whether the load that it has felt is still that of its present state.
struct LoadState {
    bool fresh = false;
    const Line* cause = nullptr;  ///< the line that made it stale; null: never computed
};
using LoadStates = std::map<std::string, LoadState>;  ///< by fluid

class LoadCheck {
 public:
    LoadCheck(const dynamics::FeltLoad& load, const LoopFacts& facts, const Flow& flow,
              std::vector<Issue>& issues)
        : load_(load), facts_(facts), flow_(flow), issues_(issues) {}

    void run() {
        LoadStates initial;
        for (const BodyFacts& body : facts_.bodies) initial[body.name];
        const auto act = [this](const FlowNode& node, LoadStates& states) { pass(node, states); };
        const std::vector<LoadStates> before = solveForward(flow_, initial, act, meet);
        for (std::size_t k = 0; k < flow_.nodes().size(); ++k)
            if (const Line* line = flow_.nodes()[k].line)
                for (const auto& [fluid, state] : before[k])
                    if (has(*line, input::AccessMode::read, loadOf(fluid)) && !state.fresh)
                        report(flow_.nodes()[k], fluid, state);
    }

 private:
    FieldKey loadOf(const std::string& fluid) const { return {fluid, std::string(load_.field)}; }

    void pass(const FlowNode& node, LoadStates& states) const {
        if (!node.line) return;
        for (auto& [fluid, state] : states) {
            const FieldKey cause{fluid, std::string(load_.stale_by)};
            if (state.fresh && has(*node.line, input::AccessMode::write, cause))
                state = {false, node.line};
            if (!node.line->every && has(*node.line, input::AccessMode::write, loadOf(fluid)))
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
        const Line& line = *node.line;
        if (!reported_.insert(line.id).second) return;
        const std::string what =
            fmt::format("{} hands on the {} that {} has felt", line.label, load_.what, fluid);
        const Line* writer = nullptr;
        for (const FlowNode& node : flow_.nodes())
            if (!writer && node.line && has(*node.line, input::AccessMode::write, loadOf(fluid)))
                writer = node.line;
        if (!writer)
            issues_.push_back(
                {Severity::error, line.id,
                 fmt::format("{}, but no line computes it: call a method of type {} for {} first",
                             what, makers(), fluid)});
        else if (state.cause)
            issues_.push_back(
                {Severity::error, line.id,
                 fmt::format("{}, but {} has changed its {} since: call {} directly after {}", what,
                             state.cause->label, load_.stale_by, line.label, writer->label)});
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
            if (maker.fields.count(std::string(load_.field)) > 0)
                names += (names.empty() ? "" : " or ") + maker.method;
        return names;
    }

    const dynamics::FeltLoad& load_;
    const LoopFacts& facts_;
    const Flow& flow_;
    std::vector<Issue>& issues_;
    std::set<int> reported_;
};

}  // namespace

void checkLoads(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    for (const dynamics::FeltLoad& load : dynamics::felt_loads)
        LoadCheck(load, facts, flow, issues).run();
}

}  // namespace sphinx::loop
