// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/fluid_force.h"

#include <fmt/format.h>

namespace sphinx::dynamics::fsi {

void checkSight(const input::Component& method, WrittenCase& written) {
    const auto& [body, from] = method.as<FluidForceParameters>();
    if (!written.sees(from.text, body.text))
        written.diagnostics.error(
            from.place, fmt::format("{} does not see {}: the topology of {} lacks '{}'", from.text,
                                    body.text, from.text, body.text));
}

void checkOtherFluids(const input::Component& method, WrittenCase& written) {
    if (!written.calls(method)) return;
    const auto& own = method.as<FluidForceParameters>();
    const auto handsOn = [&](const input::Component* other, const std::string& fluid) {
        const auto* p = other->find<FluidForceParameters>();
        return p && other->declaration == method.declaration && p->body.text == own.body.text &&
               p->from.text == fluid;
    };
    for (const WrittenCase::Sight& sight : written.topology) {
        const std::string& fluid = sight.body.text;
        if (sight.contact || sight.seen.text != own.body.text || fluid == own.from.text ||
            !written.isFluid(fluid))
            continue;
        if (std::ranges::none_of(written.called,
                                 [&](const auto* other) { return handsOn(other, fluid); }))
            written.diagnostics.warning(
                own.from.place,
                fmt::format("{0} sees {1} as well, but the loop calls no {2} from {0}: {1} feels "
                            "{3} alone",
                            fluid, own.body.text, method.declaration->name(), own.from.text));
    }
}

void checkResponds(const input::Component& method, WrittenCase& written) {
    const input::Name& body = method.as<FluidForceParameters>().body;
    if (!written.responds(body.text))
        written.diagnostics.error(
            body.place, fmt::format("{} is rigid and no body of multibody carries it: a force "
                                    "moves nothing",
                                    body.text));
}

}  // namespace sphinx::dynamics::fsi
