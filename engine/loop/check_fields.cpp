// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/checks.h"

#include <fmt/format.h>

#include <set>

namespace sphinx::loop {
namespace {

using Defined = std::set<FieldKey>;

bool isField(const FieldAccess& access) {
    return access.field != pseudo_field::neighbors && access.field != pseudo_field::fresh_neighbors;
}

void define(const FlowNode& node, Defined& defined) {
    if (node.kind == FlowNode::Kind::zero) defined.insert(node.zeroed);
    if (!node.line || node.line->sometimes) return;
    for (const FieldAccess& access : node.line->accesses)
        if (isField(access) && access.mode != AccessMode::read)
            defined.insert({access.body, access.field});
}

bool intersect(Defined& into, const Defined& from) {
    return std::erase_if(into, [&](const FieldKey& key) { return from.count(key) == 0; }) > 0;
}

std::string message(const Flow& flow, const LineFacts& reader, const FieldKey& key) {
    const LineFacts* always = nullptr;
    const LineFacts* sometimes = nullptr;
    const LineFacts* limited = nullptr;  // to a window
    const LineFacts* updates = nullptr;  // needs a value itself
    for (const FlowNode& node : flow.nodes()) {
        if (!node.line || node.line == &reader) continue;
        const bool writes = has(*node.line, AccessMode::write, key);
        if (!writes && !has(*node.line, AccessMode::accumulate, key)) continue;
        const bool reads = writes && has(*node.line, AccessMode::read, key);
        const LineFacts*& writer = reads                          ? updates
                                   : node.line->sometimes        ? sometimes
                                   : node.line->window.limited() ? limited
                                                                 : always;
        if (!writer) writer = node.line;
    }
    const std::string what = fmt::format("{} of {}", key.second, key.first);
    if (always)
        return fmt::format("{} reads {} before {} has written it: call {} earlier, or in start",
                           reader.label, what, always->label, always->label);
    if (sometimes)
        return fmt::format("{} reads {}, which {} writes only in some steps: call {} in start too",
                           reader.label, what, sometimes->label, sometimes->label);
    if (limited)
        return fmt::format("{} reads {}, which {} writes only at times {}: let it be written in the other "
                           "steps before it is read, or in start",
                           reader.label, what, limited->label, describe(limited->window));
    if (updates)
        return fmt::format("{} reads {}, which {} only updates: call a method that computes it "
                           "first",
                           reader.label, what, updates->label);
    return fmt::format("{} reads {}, which nothing writes: call a method that computes it first",
                       reader.label, what);
}

}  // namespace

void checkFields(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    Defined initial;
    for (const BodyFacts& body : facts.bodies) {
        initial.insert({body.name, "id"});
        initial.insert({body.name, "position"});
        for (const std::string& field : body.initial) initial.insert({body.name, field});
    }
    const std::vector<Defined> before = solveForward(flow, initial, define, intersect);

    Defined reported;  // the first reader stands for all
    for (std::size_t k = 0; k < flow.nodes().size(); ++k) {
        const LineFacts* line = flow.nodes()[k].line;
        if (!line) continue;
        for (const FieldAccess& access : line->accesses) {
            const FieldKey key{access.body, access.field};
            if (access.mode != AccessMode::read || !isField(access) || before[k].count(key) > 0)
                continue;
            if (reported.insert(key).second)
                issues.push_back({Severity::error, line->id, message(flow, *line, key)});
        }
    }
}

}  // namespace sphinx::loop
