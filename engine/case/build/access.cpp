// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/access.h"

#include "case/language/phases.h"

#include <algorithm>

namespace sphinx::model {
namespace {

using Words = std::vector<std::string>;

AccessMode modeOf(input::AccessMode mode) {
    switch (mode) {
        case input::AccessMode::read: return AccessMode::read;
        case input::AccessMode::write: return AccessMode::write;
        case input::AccessMode::accumulate: return AccessMode::accumulate;
        case input::AccessMode::release: return AccessMode::release;
        case input::AccessMode::open: return AccessMode::open;
        case input::AccessMode::close: return AccessMode::close;
        case input::AccessMode::within: break;
    }
    return AccessMode::within;
}

/// Bodies that a parameter refers to; a part stands for its body.
Words bodiesOf(const Case& model, const Component& method, const input::Parameter& parameter) {
    std::vector<Name> names;
    parameter.type->names(parameter.in(method.parameters.get()), names);
    Words bodies;
    for (const Name& name : names) {
        const std::string body = splitAction(name.text).first;
        if (model.findBody(body)) bodies.push_back(body);
    }
    return bodies;
}

/// Without a trait every body has it.
bool hasTrait(const Case& model, const Body& body, const std::string& trait) {
    const Words traits = bodyTraits(body.role, model.findMaterial(body.material.text));
    return trait.empty() || std::find(traits.begin(), traits.end(), trait) != traits.end();
}

Words ownerBodies(const Case& model, const Component& method, const std::string& owner) {
    const auto [name, trait] = splitAction(owner);
    if (const input::Parameter* parameter = method.declaration->parameter(name)) {
        Words bodies = bodiesOf(model, method, *parameter);
        std::erase_if(bodies, [&, &trait = trait](const std::string& body) {
            return !hasTrait(model, *model.findBody(body), trait);
        });
        return bodies;
    }
    const bool bonded = owner == "bonded";
    assert((bonded || name == "neighbors") && "owner of an access is no parameter");
    Words seen;
    for (const input::Parameter& parameter : method.declaration->parameters()) {
        const Words bodies = bodiesOf(model, method, parameter);
        for (const std::string& body : bodies)
            for (const Contact& contact : model.seenBy(body)) {
                const Body& other = *model.findBody(contact.body.text);
                const bool wanted = bonded ? contact.bonded : hasTrait(model, other, trait);
                if (wanted && std::find(seen.begin(), seen.end(), other.name) == seen.end())
                    seen.push_back(other.name);
            }
        if (!bodies.empty()) break;
    }
    return seen;
}

/// Whether a method of the loop writes the field, come what may.
bool isMade(const Case& model, const std::string& body, const std::string& field) {
    for (const Component& method : model.dynamics) {
        if (!model.calls(method.name)) continue;
        for (const input::Action& action : method.declaration->actions())
            for (const input::Access& access : action.accesses()) {
                if (access.mode != input::AccessMode::write || access.if_made ||
                    access.field != field)
                    continue;
                const Words bodies = ownerBodies(model, method, access.owner);
                if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) return true;
            }
    }
    return false;
}

}  // namespace

std::vector<FieldAccess> resolveAccesses(const Case& model, const Component& method, int action) {
    std::vector<FieldAccess> resolved;
    for (const input::Access& access : method.declaration->actions()[action].accesses())
        for (const std::string& body : ownerBodies(model, method, access.owner))
            if (!access.if_made || isMade(model, body, access.field))
                resolved.push_back({modeOf(access.mode), body, access.field});
    return resolved;
}

bool isAccessed(const Case& model, const Body& body, std::string_view field) {
    for (const Component& method : model.dynamics) {
        if (!model.calls(method.name)) continue;
        const int actions = static_cast<int>(method.declaration->actions().size());
        for (int action = 0; action < actions; ++action)
            for (const FieldAccess& access : resolveAccesses(model, method, action))
                if (access.body == body.name && access.field == field) return true;
    }
    return false;
}

}  // namespace sphinx::model
