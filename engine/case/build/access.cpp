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

Words ownerBodies(const Case& model, const Component& method, const std::string& owner) {
    if (const input::Parameter* parameter = method.declaration->parameter(owner))
        return bodiesOf(model, method, *parameter);
    const bool bonded = owner == "bonded";
    const std::string trait = splitAction(owner).second;
    assert((bonded || splitAction(owner).first == "neighbors") &&
           "owner of an access is no parameter");
    Words seen;
    for (const input::Parameter& parameter : method.declaration->parameters()) {
        const Words bodies = bodiesOf(model, method, parameter);
        for (const std::string& body : bodies)
            for (const Contact& contact : model.seenBy(body)) {
                const Body& other = *model.findBody(contact.body.text);
                const Words traits =
                    bodyTraits(other.role, model.findMaterial(other.material.text));
                const bool wanted =
                    bonded ? contact.bonded
                           : trait.empty() ||
                                 std::find(traits.begin(), traits.end(), trait) != traits.end();
                if (wanted && std::find(seen.begin(), seen.end(), other.name) == seen.end())
                    seen.push_back(other.name);
            }
        if (!bodies.empty()) break;
    }
    return seen;
}

}  // namespace

std::vector<FieldAccess> resolveAccesses(const Case& model, const Component& method, int action) {
    std::vector<FieldAccess> resolved;
    for (const input::Access& access : method.declaration->actions()[action].accesses())
        for (const std::string& body : ownerBodies(model, method, access.owner))
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
