// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rules.h"

#include <fmt/format.h>

namespace sphinx::dynamics {

bool WrittenCase::hasMaterial(std::string_view body, std::string_view trait) const {
    const auto material = materials.find(body);
    return material != materials.end() && material->second->declaration->hasTrait(trait);
}

bool WrittenCase::responds(std::string_view body) const {
    return std::ranges::find(carried, body) != carried.end() || isElastic(body);
}

void warnUnbounded(const input::Component& method, const WrittenCase& written,
                   std::string_view estimate) {
    std::vector<input::Name> bodies = method.references("body");
    for (const input::Name& body : method.references("bodies")) bodies.push_back(body);
    for (const WrittenCase::Layer& layer : written.layers) {
        const bool called = std::ranges::find(layer.called, &method) != layer.called.end();
        if (!called || layer.fixed) continue;
        for (const input::Name& body : bodies) {
            const auto bounds = [&](const input::Component* dt) {
                const auto of = dt->references("body");
                return dt->declaration->name() == estimate && of.size() == 1 &&
                       of.front().text == body.text;
            };
            if (std::ranges::any_of(layer.dt, bounds)) continue;
            written.diagnostics.warning(
                method.place, fmt::format("nothing keeps the steps of {} in layer {} below its "
                                          "limit: dt of the layer names no {} for {}",
                                          method.name, layer.name, estimate, body.text));
            return;
        }
    }
}

}  // namespace sphinx::dynamics
