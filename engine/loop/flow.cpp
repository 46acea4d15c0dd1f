// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow.h"

#include "loop/zeroing.h"

#include <algorithm>

namespace sphinx::loop {

Flow::Flow(const LoopFacts& facts) {
    for (const LineFacts& line : facts.start) add(line);
    loop_begin_ = nodes_.size();
    add(facts.outermost, &facts.outputs);
}

void Flow::add(const LineFacts& line) {
    nodes_.push_back({FlowNode::Kind::line, &line, {}, {}, 0});
}

void Flow::add(const LayerFacts& layer, const std::vector<LineFacts>* outputs) {
    const std::size_t begin = nodes_.size();
    nodes_.push_back({FlowNode::Kind::layer_begin, nullptr, &layer, {}, 0});
    for (const LineFacts& line : layer.dt) add(line);

    const std::vector<Zeroing> zeros = zeroings(layer);
    auto zero = zeros.begin();
    for (std::size_t k = 0; k < layer.steps.size(); ++k) {
        for (; zero != zeros.end() && zero->before == k; ++zero)
            nodes_.push_back({FlowNode::Kind::zero, nullptr, &layer, {zero->body, zero->field}, 0});
        if (const auto* line = std::get_if<LineFacts>(&layer.steps[k].value))
            add(*line);
        else
            add(std::get<LayerFacts>(layer.steps[k].value), nullptr);
    }
    if (outputs)
        for (const LineFacts& line : *outputs) add(line);
    nodes_.push_back({FlowNode::Kind::layer_end, nullptr, &layer, {}, begin});
}

std::vector<std::size_t> Flow::successors(std::size_t node) const {
    std::vector<std::size_t> next;
    if (nodes_[node].kind == FlowNode::Kind::layer_end) next.push_back(nodes_[node].begin);
    if (node + 1 < nodes_.size()) next.push_back(node + 1);
    return next;
}

std::optional<std::size_t> Flow::find(std::vector<std::size_t> from, const Predicate& wanted,
                                      const Predicate& stops) const {
    std::vector<bool> seen(nodes_.size(), false);
    while (!from.empty()) {
        const std::size_t node = from.back();
        from.pop_back();
        if (seen[node]) continue;
        seen[node] = true;
        if (wanted(nodes_[node])) return node;
        if (stops(nodes_[node])) continue;
        for (const std::size_t next : successors(node)) from.push_back(next);
    }
    return std::nullopt;
}

bool has(const LineFacts& line, AccessMode mode, const FieldKey& key) {
    return std::any_of(line.accesses.begin(), line.accesses.end(), [&](const FieldAccess& access) {
        return access.mode == mode && access.body == key.first && access.field == key.second;
    });
}

bool reads(const FlowNode& node, const FieldKey& key) {
    return node.line && has(*node.line, AccessMode::read, key);
}

bool replaces(const FlowNode& node, const FieldKey& key) {
    if (node.kind == FlowNode::Kind::zero) return node.zeroed == key;
    return node.line && !node.line->sometimes && has(*node.line, AccessMode::write, key);
}

}  // namespace sphinx::loop
