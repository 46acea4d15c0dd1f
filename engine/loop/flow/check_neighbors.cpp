// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace sphinx::loop {
namespace {

enum class Level { missing, stale, fresh };

struct ListState {
    Level level = Level::missing;
    const Line* cause = nullptr;  ///< the line that made it stale or invalid
};
/// One for each list.
using ListStates = std::vector<ListState>;

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

FieldKey listsOf(const std::string& body) {
    return {body, std::string(dynamics::pseudo_field::neighbors)};
}

bool rebuilds(const Line& line, const ListFacts& list) {
    return has(line, input::AccessMode::write, listsOf(list.owner)) ||
           has(line, input::AccessMode::write, listsOf(list.other));
}

/// The body of the list that the line moves, or nullptr.
const std::string* moved(const Line& line, const ListFacts& list) {
    for (const std::string* body : {&list.owner, &list.other})
        if (has(line, input::AccessMode::write, {*body, "position"})) return body;
    return nullptr;
}

bool needs(const Line& line, const ListFacts& list, std::string_view how) {
    return has(line, input::AccessMode::read, {list.owner, std::string(how)});
}

class NeighborCheck {
 public:
    NeighborCheck(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues)
        : flow_(flow), issues_(issues), lists_(facts.lists) {
        addImplicitLists();
    }

    void run() {
        findNeverRebuilt();
        const auto transfer = [&](const FlowNode& node, ListStates& states) {
            if (node.line) act(*node.line, states);
        };
        const std::vector<ListStates> before =
            solveForward(flow_, ListStates(lists_.size()), transfer, meet);
        for (std::size_t k = 0; k < flow_.nodes().size(); ++k)
            if (flow_.nodes()[k].line) judge(*flow_.nodes()[k].line, before[k]);
        for (const std::size_t end : flow_.loopEnds()) judgeRestart(end, before[end]);
    }

 private:
    /// A body whose neighbors are used although no list of it is known has one of its own.
    void addImplicitLists() {
        for (const FlowNode& node : flow_.nodes()) {
            if (!node.line) continue;
            for (const dynamics::FieldAccess& access : node.line->accesses) {
                if (access.field != dynamics::pseudo_field::neighbors &&
                    access.field != dynamics::pseudo_field::fresh_neighbors)
                    continue;
                const bool known =
                    std::any_of(lists_.begin(), lists_.end(),
                                [&](const ListFacts& l) { return l.owner == access.body; });
                if (!known && access.mode == input::AccessMode::read)
                    lists_.push_back({access.body, access.body, false});
            }
        }
    }

    void act(const Line& line, ListStates& states) const {
        for (std::size_t k = 0; k < lists_.size(); ++k) {
            const ListFacts& list = lists_[k];
            ListState& state = states[k];
            const bool rebuilt = rebuilds(line, list);
            const bool permuted =
                contains(line.permutes, list.owner) || contains(line.permutes, list.other);
            if (permuted && !rebuilt) state = {Level::missing, &line};
            if (!list.reference_configuration && state.level != Level::missing && moved(line, list))
                state = {Level::stale, &line};
            if (!line.every && rebuilt) state = {Level::fresh, nullptr};
        }
    }

    static bool meet(ListStates& into, const ListStates& from) {
        bool changed = false;
        for (std::size_t k = 0; k < into.size(); ++k) {
            if (from[k].level >= into[k].level) continue;
            into[k] = from[k];
            changed = true;
        }
        return changed;
    }

    /// "call neighbors", or what to do when there is no such line.
    std::string remedy(const ListFacts& list) const {
        for (const FlowNode& node : flow_.nodes())
            if (node.line && rebuilds(*node.line, list)) return "call " + node.line->label;
        return fmt::format("add a method neighbors.update for {} and call it", list.owner);
    }

    /// One message for each body and kind of trouble.
    void report(const Line& line, const std::string& body, const std::string& message) {
        if (reported_.insert(body).second) issues_.push_back({Severity::error, line.id, message});
    }

    void findNeverRebuilt() {
        for (std::size_t epoch = 0; epoch < flow_.epochs(); ++epoch)
            for (const ListFacts& list : lists_)
                if (!list.reference_configuration) findNeverRebuilt(list, epoch);
    }

    void findNeverRebuilt(const ListFacts& list, std::size_t epoch) {
        const Line* mover = nullptr;
        for (std::size_t k = flow_.loopBegins().front(); k < flow_.nodes().size(); ++k) {
            const FlowNode& node = flow_.nodes()[k];
            if (!node.line || node.epoch != epoch) continue;
            if (rebuilds(*node.line, list)) return;
            if (!mover && moved(*node.line, list)) mover = node.line;
        }
        if (!mover) return;
        report(*mover, list.owner,
               fmt::format("{} moves {}, but{} no line of the loop updates the neighbors of {}: {} "
                           "after it",
                           mover->label, *moved(*mover, list), flow_.epochText(epoch), list.owner,
                           remedy(list)));
    }

    void judge(const Line& line, const ListStates& states) {
        for (std::size_t k = 0; k < lists_.size(); ++k) {
            const ListFacts& list = lists_[k];
            const ListState& state = states[k];
            const bool fresh = needs(line, list, dynamics::pseudo_field::fresh_neighbors);
            if (!fresh && !needs(line, list, dynamics::pseudo_field::neighbors)) continue;
            if (state.level == Level::missing && !state.cause)
                report(line, list.owner,
                       fmt::format("{} uses the neighbors of {} before they were built: {} in "
                                   "start",
                                   line.label, list.owner, remedy(list)));
            else if (state.level == Level::missing)
                report(line, list.owner,
                       fmt::format("{} uses the neighbors of {}, which {} has made invalid: {} in "
                                   "every step after {}",
                                   line.label, list.owner, state.cause->label, remedy(list),
                                   state.cause->label));
            else if (state.level == Level::stale && fresh)
                report(line, list.owner,
                       fmt::format("{} needs up-to-date neighbors of {}, but {} has moved {} "
                                   "since they were built: {} between the two",
                                   line.label, list.owner, state.cause->label,
                                   *moved(*state.cause, list), remedy(list)));
        }
    }

    /// A restart rebuilds lists from the positions at the end of a step. Lists that are older
    /// than these positions and still used in the next step cannot come back.
    void judgeRestart(std::size_t end, const ListStates& at_end) {
        for (std::size_t k = 0; k < lists_.size(); ++k) {
            const ListFacts& list = lists_[k];
            if (at_end[k].level != Level::stale) continue;
            const auto user = flow_.find(
                flow_.nodes()[end].next,
                [&](const FlowNode& node) {
                    return node.line && needs(*node.line, list, dynamics::pseudo_field::neighbors);
                },
                [&](const FlowNode& node) {
                    return node.line && !node.line->every && rebuilds(*node.line, list);
                });
            if (!user) continue;
            const Line& line = *flow_.nodes()[*user].line;
            report(
                line, list.owner,
                fmt::format("{} uses neighbors of {} from before {} moved {} in the last step, "
                            "which a resumed run does not have: {} in every step after {}",
                            line.label, list.owner, at_end[k].cause->label,
                            *moved(*at_end[k].cause, list), remedy(list), at_end[k].cause->label));
        }
    }

    const Flow& flow_;
    std::vector<Issue>& issues_;
    std::vector<ListFacts> lists_;
    std::set<std::string> reported_;
};

}  // namespace

void checkNeighbors(const LoopFacts& facts, const Flow& flow, std::vector<Issue>& issues) {
    NeighborCheck(facts, flow, issues).run();
}

}  // namespace sphinx::loop
