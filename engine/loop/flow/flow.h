// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loop/flow/facts.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sphinx::loop {

/// Body and field.
using FieldKey = std::pair<std::string, std::string>;

/// One point of the program that a loop is.
struct FlowNode {
    enum class Kind { line, zero, layer_begin, layer_end };

    Kind kind = Kind::line;
    const Line* line = nullptr;     ///< line
    const Layer* layer = nullptr;   ///< layer_begin, layer_end, zero
    FieldKey zeroed;                ///< zero
    std::size_t epoch = 0;          ///< that of its layer's substep
    std::vector<std::size_t> next;  ///< nodes that may follow
};

/// The loop as a program: start lines, then the outermost layer (each layer runs at least once, its
/// estimates first; accumulated fields are zeroed before their first accumulator), and back. Refers
/// to the facts.
///
/// The windows of lines divide time into epochs, in each of which a line acts always or never. The
/// program has every layer that windows concern once for each epoch in which its substep may begin:
/// an inner one can be ahead of its parent, none goes back, and a step may leave epochs out.
class Flow {
 public:
    explicit Flow(const LoopFacts& facts);

    const std::vector<FlowNode>& nodes() const { return nodes_; }
    /// Where outermost steps begin and end: one node for each epoch.
    const std::vector<std::size_t>& loopBegins() const { return loop_begins_; }
    const std::vector<std::size_t>& loopEnds() const { return loop_ends_; }
    std::size_t epochs() const { return window_edges_.size() + 1; }
    /// " at times from 0.4 until 0.5"; empty when there is only one epoch.
    std::string epochText(std::size_t epoch) const;

    /// Walks on from `from` (included) on all paths that no `stops` node cuts; returns the first
    /// node found that `wanted` accepts. A node is looked at before it stops.
    using Predicate = std::function<bool(const FlowNode&)>;
    std::optional<std::size_t> find(std::vector<std::size_t> from, const Predicate& wanted,
                                    const Predicate& stops) const;

 private:
    void collectWindows(const Layer& layer);
    bool acts(const Line& line, std::size_t epoch) const;
    /// Its begins and its ends, one for each epoch.
    using Ends = std::pair<std::vector<std::size_t>, std::vector<std::size_t>>;
    Ends add(const Layer& layer, std::size_t first_epoch);
    void addSteps(const Layer& layer, std::size_t epoch);
    void add(FlowNode node);

    double start_time_;
    std::string time_unit_;
    std::vector<double> window_edges_;  // after the start, ascending
    std::vector<FlowNode> nodes_;
    std::vector<std::size_t> ends_;  // nodes that the next one follows
    std::vector<std::size_t> loop_begins_;
    std::vector<std::size_t> loop_ends_;
};

bool has(const Line& line, input::AccessMode mode, const FieldKey& key);
/// The node reads the field, or gives it a new value in every pass.
bool reads(const FlowNode& node, const FieldKey& key);
bool replaces(const FlowNode& node, const FieldKey& key);

/// State before each node: what holds on every path there. `transfer(node, state)` changes the
/// state as the node does; `meet(into, from)` weakens `into` to what both hold and tells whether
/// it changed.
template <class State, class Transfer, class Meet>
std::vector<State> solveForward(const Flow& flow, const State& initial, Transfer transfer,
                                Meet meet) {
    std::vector<std::optional<State>> before(flow.nodes().size());
    before[0] = initial;
    std::vector<std::size_t> changed = {0};
    while (!changed.empty()) {
        const std::size_t node = changed.back();
        changed.pop_back();
        State state = *before[node];
        transfer(flow.nodes()[node], state);
        for (const std::size_t next : flow.nodes()[node].next) {
            if (before[next] && !meet(*before[next], state)) continue;
            if (!before[next]) before[next] = state;
            changed.push_back(next);
        }
    }
    std::vector<State> result;
    for (auto& state : before) result.push_back(std::move(*state));
    return result;
}

}  // namespace sphinx::loop
