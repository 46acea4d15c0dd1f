// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/phases.h"

#include <set>
#include <string>

namespace sphinx::language {

using input::Reference;
using input::Target;

void warnUnused(const CaseBlock& block, const input::Reader& reader) {
    reader.scope.warnUnused(reader.diagnostics);
    std::set<std::pair<Target, std::string>> used;
    for (const Reference& reference : reader.references) {
        const bool action = reference.target == Target::action;
        used.emplace(action ? Target::method : reference.target,
                     action ? model::splitAction(reference.name.text).first : reference.name.text);
    }
    const auto warn = [&](Target target, const char* what, const std::string& name,
                          const input::Place& place) {
        const bool included = place.source && place.source->order != 0;
        if (!included && !used.contains({target, name}))
            reader.diagnostics.warning(
                place, std::string("the ") + what + " '" + name + "' is never used");
    };
    for (const NamedShape& shape : block.geometry)
        warn(Target::shape, "shape", shape.name, shape.place);
    for (const input::Component& material : block.materials)
        warn(Target::material, "material", material.name, material.place);
    for (const input::Component& method : block.dynamics)
        warn(Target::method, "method", method.name, method.place);
}

}  // namespace sphinx::language
