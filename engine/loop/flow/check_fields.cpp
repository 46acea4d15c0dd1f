// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace sphinx::loop {
namespace {

using Defined = std::set<FieldKey>;

bool isField(const dynamics::FieldAccess& access) { return !dynamics::isPseudoField(access.field); }

void define(const FlowNode& node, Defined& defined) {
    if (node.kind == FlowNode::Kind::zero) defined.insert(node.zeroed);
    if (!node.line || node.line->every) return;
    for (const dynamics::FieldAccess& access : node.line->accesses)
        if (isField(access) && input::changes(access.mode))
            defined.insert({access.body, access.field});
}

bool intersect(Defined& into, const Defined& from) {
    return std::erase_if(into, [&](const FieldKey& key) { return from.count(key) == 0; }) > 0;
}

/// The first line of each kind that writes a field, the reader left aside.
struct Writers {
    const Line* always = nullptr;
    const Line* sometimes = nullptr;
    const Line* limited = nullptr;  // to a window
    const Line* updates = nullptr;  // needs a value itself

    Writers(const Flow& flow, const Line& reader, const FieldKey& key) {
        for (const FlowNode& node : flow.nodes()) {
            if (!node.line || node.line == &reader) continue;
            const bool writes = has(*node.line, input::AccessMode::write, key);
            if (!writes && !has(*node.line, input::AccessMode::accumulate, key)) continue;
            const bool reads = writes && has(*node.line, input::AccessMode::read, key);
            const Line*& writer = reads                         ? updates
                                  : node.line->every            ? sometimes
                                  : node.line->window.limited() ? limited
                                                                : always;
            if (!writer) writer = node.line;
        }
    }
    bool anyFromScratch() const { return always || sometimes || limited; }
};

class FieldCheck {
 public:
    FieldCheck(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues)
        : facts_(facts), flow_(flow), issues_(issues) {}

    /// The first reader stands for all, and one missing method for all that it would compute.
    void report(const Line& reader, const FieldKey& key) {
        if (!reported_.insert(key).second) return;
        for (const FieldMaker* maker : advised_[key.first])
            if (maker->fields.count(key.second) > 0) return;
        const Writers writers(flow_, reader, key);
        const FieldMaker* maker = writers.anyFromScratch() ? nullptr : onlyMaker(key.second);
        if (maker) advised_[key.first].push_back(maker);
        const std::string text =
            maker ? advice(reader, key, *maker) : message(reader, key, writers);
        issues_.push_back({Severity::error, reader.id, text});
    }

 private:
    const FieldMaker* onlyMaker(const std::string& field) const {
        const FieldMaker* only = nullptr;
        for (const FieldMaker& maker : facts_.makers) {
            if (maker.fields.count(field) == 0) continue;
            if (only) return nullptr;
            only = &maker;
        }
        return only;
    }

    static std::string advice(const Line& reader, const FieldKey& key, const FieldMaker& maker) {
        return fmt::format(
            "{} reads {} of {}, which nothing computes: call a method of type {} for {} "
            "first",
            reader.label, key.second, key.first, maker.method, key.first);
    }

    std::string message(const Line& reader, const FieldKey& key, const Writers& writers) const {
        const std::string what = fmt::format("{} of {}", key.second, key.first);
        if (writers.always)
            return fmt::format("{} reads {} before {} has written it: call {} earlier, or in start",
                               reader.label, what, writers.always->label, writers.always->label);
        if (writers.sometimes)
            return fmt::format(
                "{} reads {}, which {} writes only in some steps: call {} in start too",
                reader.label, what, writers.sometimes->label, writers.sometimes->label);
        if (writers.limited)
            return fmt::format(
                "{} reads {}, which {} writes only at times {}: let it be written in "
                "the other steps before it is read, or in start",
                reader.label, what, writers.limited->label,
                describe(writers.limited->window, facts_.time_unit));
        if (writers.updates)
            return fmt::format(
                "{} reads {}, which {} only updates: call a method that computes it "
                "first",
                reader.label, what, writers.updates->label);
        const auto remedy = facts_.remedies.find(key.second);
        return fmt::format("{} reads {}, which nothing writes: {}", reader.label, what,
                           remedy == facts_.remedies.end() ? "call a method that computes it first"
                                                           : remedy->second);
    }

    const LoopFacts& facts_;
    const Flow& flow_;
    std::vector<Issue>& issues_;
    Defined reported_;
    std::map<std::string, std::vector<const FieldMaker*>> advised_;  // by body
};

}  // namespace

void checkFields(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    Defined initial;
    for (const BodyFacts& body : facts.bodies) {
        initial.insert({body.name, "id"});
        initial.insert({body.name, "position"});
        for (const std::string& field : body.initial) initial.insert({body.name, field});
    }
    const std::vector<Defined> before = solveForward(flow, initial, define, intersect);

    FieldCheck check(facts, flow, issues);
    for (std::size_t k = 0; k < flow.nodes().size(); ++k) {
        const Line* line = flow.nodes()[k].line;
        if (!line) continue;
        for (const dynamics::FieldAccess& access : line->accesses) {
            const FieldKey key{access.body, access.field};
            if (access.mode != input::AccessMode::read || !isField(access) ||
                before[k].count(key) > 0)
                continue;
            check.report(*line, key);
        }
    }
}

}  // namespace sphinx::loop
