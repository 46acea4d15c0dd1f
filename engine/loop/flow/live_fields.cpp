// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/live_fields.h"

#include "loop/flow/flow.h"

namespace sphinx::loop {

std::map<std::string, std::set<std::string>> liveFields(const LoopFacts& facts) {
    const Flow flow(facts);
    std::map<std::string, std::set<std::string>> live;
    std::set<FieldKey> known;
    for (const BodyFacts& body : facts.bodies) {
        live[body.name] = {"id", "position"};
        for (const std::string& field : body.initial) known.insert({body.name, field});
    }
    for (const FlowNode& node : flow.nodes())
        if (node.line)
            for (const dynamics::FieldAccess& access : node.line->accesses)
                if (!dynamics::isPseudoField(access.field))
                    known.insert({access.body, access.field});

    for (const FieldKey& key : known) {
        const bool used =
            flow.find(
                    flow.loopBegins(), [&](const FlowNode& node) { return reads(node, key); },
                    [&](const FlowNode& node) { return replaces(node, key); })
                .has_value();
        if (used || key.second == "velocity") live[key.first].insert(key.second);
    }
    return live;
}

}  // namespace sphinx::loop
