// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace sphinx::loop {
namespace {

class SpanCheck {
 public:
    SpanCheck(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues)
        : flow_(flow), issues_(issues) {
        for (const BodyFacts& body : facts.bodies)
            if (body.moves) moving_.insert(body.name);
        for (const FlowNode& node : flow.nodes())
            if (node.line)
                for (const dynamics::FieldAccess& access : node.line->accesses)
                    if (access.mode == input::AccessMode::open)
                        opened_.insert({access.body, access.field});
    }

    void run() {
        for (const FieldKey& span : opened_) {
            unopened(span, input::AccessMode::close, "ends");
            unopened(span, input::AccessMode::within, "acts within");
            reopened(span);
            permuted(span);
        }
        for (const FlowNode& node : flow_.nodes())
            if (node.line)
                for (const dynamics::FieldAccess& access : node.line->accesses)
                    neverOpened(*node.line, access);
    }

 private:
    bool uses(std::size_t node, input::AccessMode mode, const FieldKey& span) const {
        const Line* line = flow_.nodes()[node].line;
        return line && has(*line, mode, span);
    }
    /// Nodes that follow those of that mode.
    std::vector<std::size_t> after(input::AccessMode mode, const FieldKey& span) const {
        std::vector<std::size_t> from;
        for (std::size_t k = 0; k < flow_.nodes().size(); ++k)
            if (uses(k, mode, span))
                from.insert(from.end(), flow_.nodes()[k].next.begin(), flow_.nodes()[k].next.end());
        return from;
    }
    /// A line of that mode where the span is closed. In start a constraint may act before any step.
    void unopened(const FieldKey& span, input::AccessMode mode, const char* does) {
        std::vector<std::size_t> from = after(input::AccessMode::close, span);
        from.insert(from.end(), flow_.loopBegins().begin(), flow_.loopBegins().end());
        if (mode == input::AccessMode::close) from.push_back(0);
        const std::size_t loop = flow_.loopBegins().front();
        const auto index = [&](const FlowNode& node) {
            return static_cast<std::size_t>(&node - flow_.nodes().data());
        };
        const auto found = flow_.find(
            from,
            [&](const FlowNode& node) {
                const bool in_start = index(node) < loop;
                return node.line && has(*node.line, mode, span) &&
                       !(in_start && mode == input::AccessMode::within);
            },
            [&](const FlowNode& node) {
                return node.line && has(*node.line, input::AccessMode::open, span);
            });
        if (found)
            report(*flow_.nodes()[*found].line,
                   fmt::format("{} {} a {} of {}, but none has begun there: it belongs {} {}",
                               flow_.nodes()[*found].line->label, does, span.second, span.first,
                               mode == input::AccessMode::close ? "after" : "between",
                               mode == input::AccessMode::close
                                   ? opener(span)
                                   : opener(span) + " and " + closer(span)));
    }
    void reopened(const FieldKey& span) {
        const auto found = flow_.find(
            after(input::AccessMode::open, span),
            [&](const FlowNode& node) {
                return node.line && has(*node.line, input::AccessMode::open, span);
            },
            [&](const FlowNode& node) {
                return node.line && has(*node.line, input::AccessMode::close, span);
            });
        if (found)
            report(*flow_.nodes()[*found].line,
                   fmt::format("{} begins a {} of {} before the one that {} began has ended",
                               flow_.nodes()[*found].line->label, span.second, span.first,
                               opener(span)));
    }
    /// Who opened it may have kept values particle by particle.
    void permuted(const FieldKey& span) {
        const auto found = flow_.find(
            after(input::AccessMode::open, span),
            [&](const FlowNode& node) {
                return node.line &&
                       std::find(node.line->permutes.begin(), node.line->permutes.end(),
                                 span.first) != node.line->permutes.end();
            },
            [&](const FlowNode& node) {
                return node.line && has(*node.line, input::AccessMode::close, span);
            });
        if (found)
            report(*flow_.nodes()[*found].line,
                   fmt::format("{} may reorder or remove particles of {} within a {} of it, whose "
                               "end has to find them as they were: it belongs after {}",
                               flow_.nodes()[*found].line->label, span.first, span.second,
                               closer(span)));
    }
    /// A wall that is moved has no steps.
    void neverOpened(const Line& line, const dynamics::FieldAccess& access) {
        const bool needed =
            access.mode == input::AccessMode::close ||
            (access.mode == input::AccessMode::within && moving_.count(access.body) > 0);
        if (needed && opened_.count({access.body, access.field}) == 0)
            report(line,
                   fmt::format("{} {} a {} of {} that no line begins", line.label,
                               access.mode == input::AccessMode::close ? "ends" : "acts within",
                               access.field, access.body));
    }
    std::string labelOf(input::AccessMode mode, const FieldKey& span, const char* none) const {
        for (const FlowNode& node : flow_.nodes())
            if (node.line && has(*node.line, mode, span)) return node.line->label;
        return none;
    }
    std::string opener(const FieldKey& span) const {
        return labelOf(input::AccessMode::open, span, "");
    }
    std::string closer(const FieldKey& span) const {
        return labelOf(input::AccessMode::close, span, "its end");
    }
    void report(const Line& line, std::string text) {
        if (reported_.insert(line.id).second)
            issues_.push_back({Severity::error, line.id, std::move(text)});
    }

    const Flow& flow_;
    std::vector<Issue>& issues_;
    std::set<std::string> moving_;
    std::set<FieldKey> opened_;
    std::set<int> reported_;
};

}  // namespace

void checkSpans(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    SpanCheck(facts, flow, issues).run();
}

}  // namespace sphinx::loop
