// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace sphinx::loop {
namespace {

/// The last time of the loop in which something gives a field a value, and the first line that does
/// so then.
struct LastWrite {
    std::size_t epoch = 0;
    const Line* line = nullptr;  ///< null: the layer zeroes it
};

class EndedCheck {
 public:
    EndedCheck(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues)
        : facts_(facts), flow_(flow), issues_(issues) {
        collectSteps(facts.plan.outermost);
        for (std::size_t k = flow.loopBegins().front(); k < flow.nodes().size(); ++k) {
            const FlowNode& node = flow.nodes()[k];
            if (node.kind == FlowNode::Kind::zero) add(node.zeroed, node);
            if (!node.line) continue;
            for (const dynamics::FieldAccess& access : node.line->accesses) {
                if (input::changes(access.mode)) add({access.body, access.field}, node);
                if (access.mode == input::AccessMode::release)
                    released_.insert({access.body, access.field});
            }
        }
    }

    void run() {
        for (const FlowNode& node : flow_.nodes())
            if (node.line && steps_.count(node.line) > 0)
                for (const dynamics::FieldAccess& access : node.line->accesses)
                    if (access.mode == input::AccessMode::read)
                        judge(*node.line, node.epoch, {access.body, access.field});
    }

 private:
    /// An estimate of a time step and an output may look at what stands still.
    void collectSteps(const Layer& layer) {
        for (const Step& step : layer.steps)
            if (const auto* line = std::get_if<Call>(&step.value))
                steps_.insert(line);
            else
                collectSteps(std::get<Layer>(step.value));
    }

    void add(const FieldKey& key, const FlowNode& node) {
        const auto [last, is_new] = last_.insert({key, {node.epoch, node.line}});
        if (!is_new && node.epoch > last->second.epoch) last->second = {node.epoch, node.line};
    }

    /// The first reader stands for all; it may have been found to read too early already.
    void judge(const Line& reader, std::size_t epoch, const FieldKey& key) {
        const auto last = last_.find(key);
        // What no longer moves is where it is; lists and loads have checks of their own.
        if (last == last_.end() || epoch <= last->second.epoch || key.second == "position" ||
            dynamics::isPseudoField(key.second) || released_.count(key) > 0)
            return;
        const bool known = std::any_of(issues_.begin(), issues_.end(),
                                       [&](const Issue& issue) { return issue.id == reader.id; });
        if (known || !reported_.insert(key).second) return;
        const Line& writer = *last->second.line;
        issues_.push_back(
            {Severity::error, reader.id,
             fmt::format("{} reads {} of {}, which {} writes only at times {}: it would keep its "
                         "last value for ever; let {} end with it, or something write it later",
                         reader.label, key.second, key.first, writer.label,
                         describe(writer.window, facts_.time_unit), reader.label)});
    }

    const LoopFacts& facts_;
    const Flow& flow_;
    std::vector<Issue>& issues_;
    std::set<const Line*> steps_;
    std::map<FieldKey, LastWrite> last_;
    std::set<FieldKey> released_;
    std::set<FieldKey> reported_;
};

}  // namespace

void checkEnded(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    EndedCheck(facts, flow, issues).run();
}

}  // namespace sphinx::loop
