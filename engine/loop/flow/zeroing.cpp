// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/flow/zeroing.h"

#include <set>
#include <utility>

namespace sphinx::loop {

std::vector<Zeroing> zeroings(const Layer& layer) {
    std::vector<Zeroing> all;
    std::set<std::pair<std::string, std::string>> seen;
    for (std::size_t k = 0; k < layer.steps.size(); ++k) {
        const auto* line = std::get_if<Call>(&layer.steps[k].value);
        if (!line) continue;
        for (const dynamics::FieldAccess& access : line->accesses)
            if (access.mode == input::AccessMode::accumulate && !access.result &&
                seen.insert({access.body, access.field}).second)
                all.push_back({access.body, access.field, k});
    }
    return all;
}

}  // namespace sphinx::loop
