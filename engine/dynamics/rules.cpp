// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rules.h"

#include "input/declaration/declaration.h"

#include <fmt/format.h>

namespace sphinx::dynamics {

std::vector<input::Name> WrittenCase::references(const input::Component& method,
                                                 std::string_view parameter) {
    std::vector<input::Name> names;
    if (const input::Parameter* found = method.declaration->parameter(parameter))
        found->type->names(found->in(method.parameters.get()), names);
    return names;
}

void warnUnbounded(const input::Component& method, const WrittenCase& written,
                   std::string_view estimate) {
    const auto bodies = WrittenCase::references(method, "body");
    const auto bounds = [&](const input::Component* dt) {
        return dt->declaration->name() == estimate &&
               WrittenCase::references(*dt, "body") == bodies;
    };
    for (const WrittenCase::Layer& layer : written.layers) {
        const bool called = std::ranges::find(layer.called, &method) != layer.called.end();
        if (!called || layer.fixed || std::ranges::any_of(layer.dt, bounds)) continue;
        written.diagnostics.warning(
            method.place, fmt::format("nothing keeps the steps of {} in layer {} below its limit: "
                                      "dt of the layer names no {} for {}",
                                      method.name, layer.name, estimate, bodies.front().text));
        return;
    }
}

}  // namespace sphinx::dynamics
