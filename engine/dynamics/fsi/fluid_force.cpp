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

void checkResponds(const input::Component& method, WrittenCase& written) {
    const input::Name& body = method.as<FluidForceParameters>().body;
    if (!written.responds(body.text))
        written.diagnostics.error(
            body.place, fmt::format("{} is rigid and no body of multibody carries it: a force "
                                    "moves nothing",
                                    body.text));
}

}  // namespace sphinx::dynamics::fsi
