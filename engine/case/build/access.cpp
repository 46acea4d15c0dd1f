// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/access.h"

#include "case/language/phases.h"

#include <algorithm>

namespace sphinx::build {
namespace {

using Words = std::vector<std::string>;

/// Bodies that a parameter refers to; a part stands for its body.
Words bodiesOf(const model::Case& model, const input::Component& method,
               const input::Parameter& parameter) {
    Words bodies;
    for (const input::Name& name : method.references(parameter)) {
        const std::string body = model::splitAction(name.text).first;
        if (model.findBody(body)) bodies.push_back(body);
    }
    return bodies;
}

/// Without a trait every body has it. `responding`: bodies::Body::responds(); `driven`: rigid ones
/// that do not; `carried`: rigid ones that do.
bool hasTrait(const model::Case& model, const model::Body& body, const std::string& trait) {
    if (trait == "responding") return model.responds(body);
    if (trait == "driven") return body.role == bodies::Role::wall && !model.responds(body);
    if (trait == "carried") return body.role == bodies::Role::wall && model.responds(body);
    const Words traits = language::bodyTraits(body.role, model.findMaterial(body.material.text));
    return trait.empty() || std::find(traits.begin(), traits.end(), trait) != traits.end();
}

Words ownerBodies(const model::Case& model, const input::Component& method,
                  const std::string& owner) {
    const auto [name, trait] = model::splitAction(owner);
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
            for (const model::Seen& one : model.seenBy(body)) {
                if (one.as == model::SeenAs::contact) continue;
                const model::Body& other = *model.findBody(one.body.text);
                const bool wanted =
                    bonded ? one.as == model::SeenAs::bonded : hasTrait(model, other, trait);
                if (wanted && std::find(seen.begin(), seen.end(), other.name) == seen.end())
                    seen.push_back(other.name);
            }
        if (!bodies.empty()) break;
    }
    return seen;
}

/// Whether a method of the loop writes or accumulates the field, come what may.
bool isMade(const model::Case& model, const std::string& body, const std::string& field) {
    for (const input::Component& method : model.dynamics) {
        if (!model.calls(method.name)) continue;
        for (const input::Action& action : method.declaration->actions())
            for (const input::Access& access : action.accesses()) {
                if (!input::changes(access.mode) || access.if_made || access.field != field)
                    continue;
                const Words bodies = ownerBodies(model, method, access.owner);
                if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) return true;
            }
    }
    return false;
}

}  // namespace

std::vector<dynamics::FieldAccess> resolveAccesses(const model::Case& model,
                                                   const input::Component& method, int action) {
    std::vector<dynamics::FieldAccess> resolved;
    for (const input::Access& access : method.declaration->actions()[action].accesses())
        for (const std::string& body : ownerBodies(model, method, access.owner))
            if (!access.if_made || isMade(model, body, access.field))
                resolved.push_back({access.mode, body, access.field, access.result});
    return resolved;
}

bool isAccessed(const model::Case& model, const model::Body& body, std::string_view field) {
    for (const input::Component& method : model.dynamics) {
        if (!model.calls(method.name)) continue;
        const int actions = static_cast<int>(method.declaration->actions().size());
        for (int action = 0; action < actions; ++action)
            for (const dynamics::FieldAccess& access : resolveAccesses(model, method, action))
                if (access.body == body.name && access.field == field) return true;
    }
    return false;
}

}  // namespace sphinx::build
