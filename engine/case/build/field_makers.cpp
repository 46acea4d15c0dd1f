// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/field_makers.h"

#include <algorithm>

namespace sphinx::build {

std::vector<loop::FieldMaker> fieldMakers(const input::Registry& registry) {
    std::vector<loop::FieldMaker> makers;
    for (const std::string& name : registry.names(input::Kind::dynamics)) {
        const input::Declaration& declaration = *registry.find(input::Kind::dynamics, name);
        if (declaration.isTimeStep()) continue;
        loop::FieldMaker maker{name, {}};
        for (const input::Action& action : declaration.actions()) {
            const auto& all = action.accesses();
            for (const input::Access& access : all) {
                const bool is_read =
                    std::any_of(all.begin(), all.end(), [&](const input::Access& other) {
                        return other.mode == input::AccessMode::read &&
                               other.owner == access.owner && other.field == access.field;
                    });
                if (access.mode == input::AccessMode::write && !is_read)
                    maker.fields.insert(access.field);
            }
        }
        if (!maker.fields.empty()) makers.push_back(std::move(maker));
    }
    return makers;
}

}  // namespace sphinx::build
