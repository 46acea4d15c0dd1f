// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rules.h"

#include <fmt/format.h>

namespace sphinx::dynamics {

bool WrittenCase::isElastic(std::string_view body) const {
    const auto material = materials.find(body);
    return material != materials.end() && material->second->declaration->hasTrait("elastic");
}

bool WrittenCase::responds(std::string_view body) const {
    return std::ranges::find(carried, body) != carried.end() || isElastic(body);
}

void warnUnbounded(const input::Component& method, const WrittenCase& written,
                   std::string_view estimate) {
    const auto bodies = method.references("body");
    const auto bounds = [&](const input::Component* dt) {
        return dt->declaration->name() == estimate && dt->references("body") == bodies;
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
