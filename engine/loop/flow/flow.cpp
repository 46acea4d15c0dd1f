// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/flow.h"

#include "loop/flow/zeroing.h"

#include <algorithm>
#include <tuple>

namespace sphinx::loop {

namespace {

bool hasWindows(const Layer& layer) {
    return std::any_of(layer.steps.begin(), layer.steps.end(), [](const Step& step) {
        const auto* line = std::get_if<Call>(&step.value);
        return line ? line->window.limited() : hasWindows(std::get<Layer>(step.value));
    });
}

}  // namespace

Flow::Flow(const LoopFacts& facts)
    : start_time_(facts.plan.start_time), time_unit_(facts.time_unit) {
    collectWindows(facts.plan.outermost);
    std::sort(window_edges_.begin(), window_edges_.end());
    window_edges_.erase(std::unique(window_edges_.begin(), window_edges_.end()),
                        window_edges_.end());
    for (const Call& line : facts.plan.start) add({FlowNode::Kind::line, &line, {}, {}, 0, {}});
    std::tie(loop_begins_, loop_ends_) = add(facts.plan.outermost, 0);
}

void Flow::collectWindows(const Layer& layer) {
    for (const Step& step : layer.steps) {
        if (const auto* inner = std::get_if<Layer>(&step.value)) {
            collectWindows(*inner);
            continue;
        }
        const Window& window = std::get<Call>(step.value).window;
        for (const std::optional<double>& edge : {window.from, window.until})
            if (edge && *edge > start_time_) window_edges_.push_back(*edge);
    }
}

bool Flow::acts(const Line& line, std::size_t epoch) const {
    return line.window.holds(epoch == 0 ? start_time_ : window_edges_[epoch - 1]);
}

std::string Flow::epochText(std::size_t epoch) const {
    Window window;
    if (epoch > 0) window.from = window_edges_[epoch - 1];
    if (epoch < window_edges_.size()) window.until = window_edges_[epoch];
    return window.limited() ? " at times " + describe(window, time_unit_) : "";
}

void Flow::add(FlowNode node) {
    for (const std::size_t end : ends_) nodes_[end].next.push_back(nodes_.size());
    ends_ = {nodes_.size()};
    nodes_.push_back(std::move(node));
}

void Flow::addSteps(const Layer& layer, std::size_t epoch) {
    const std::vector<Zeroing> zeros = zeroings(layer);
    auto zero = zeros.begin();
    for (std::size_t k = 0; k < layer.steps.size(); ++k) {
        for (; zero != zeros.end() && zero->before == k; ++zero)
            add({FlowNode::Kind::zero, nullptr, &layer, {zero->body, zero->field}, epoch, {}});
        if (const auto* inner = std::get_if<Layer>(&layer.steps[k].value)) {
            add(*inner, epoch);
            continue;
        }
        const auto& line = std::get<Call>(layer.steps[k].value);
        if (acts(line, epoch)) add({FlowNode::Kind::line, &line, {}, {}, epoch, {}});
    }
}

Flow::Ends Flow::add(const Layer& layer, std::size_t first_epoch) {
    const std::size_t last_epoch = hasWindows(layer) ? epochs() - 1 : first_epoch;
    std::vector<std::size_t> begins, ends;
    for (std::size_t epoch = first_epoch; epoch <= last_epoch; ++epoch) {
        // Its first substep begins with its parent's, so in the first epoch.
        if (epoch > first_epoch) ends_.clear();
        begins.push_back(nodes_.size());
        add({FlowNode::Kind::layer_begin, nullptr, &layer, {}, epoch, {}});
        for (const TimeStep& line : layer.dt) add({FlowNode::Kind::line, &line, {}, {}, epoch, {}});
        addSteps(layer, epoch);
        ends.push_back(nodes_.size());
        add({FlowNode::Kind::layer_end, nullptr, &layer, {}, epoch, {}});
        for (const std::size_t end : ends) nodes_[end].next.push_back(begins.back());
    }
    ends_ = ends;
    return {begins, ends};
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
        from.insert(from.end(), nodes_[node].next.begin(), nodes_[node].next.end());
    }
    return std::nullopt;
}

bool has(const Line& line, input::AccessMode mode, const FieldKey& key) {
    return std::any_of(
        line.accesses.begin(), line.accesses.end(), [&](const dynamics::FieldAccess& access) {
            return access.mode == mode && access.body == key.first && access.field == key.second;
        });
}

bool reads(const FlowNode& node, const FieldKey& key) {
    return node.line && has(*node.line, input::AccessMode::read, key);
}

bool replaces(const FlowNode& node, const FieldKey& key) {
    if (node.kind == FlowNode::Kind::zero) return node.zeroed == key;
    return node.line && !node.line->every && has(*node.line, input::AccessMode::write, key);
}

}  // namespace sphinx::loop
