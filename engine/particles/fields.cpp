// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/fields.h"

namespace sphinx::fields {

const std::vector<const FieldInfo*>& all() {
    static const std::vector<const FieldInfo*> list = {
        &id,
        &position,
        &velocity,
        &mass,
        &volume,
        &density,
        &density_rate,
        &reference_density,
        &pressure,
        &acceleration,
        &external_acceleration,
        &normal,
        &depth,
        &fibre,
        &sheet,
    };
    return list;
}

const FieldInfo* find(std::string_view name) {
    for (const FieldInfo* info : all())
        if (info->name == name) return info;
    return nullptr;
}

}  // namespace sphinx::fields
