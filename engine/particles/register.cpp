// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "particles/register.h"

#include "input/expressions/units.h"
#include "particles/fields.h"

#include <fmt/format.h>

namespace sphinx::particles {
namespace {

struct NoParameters {};

const char* rankName(Rank rank) {
    switch (rank) {
        case Rank::scalar: return "scalar";
        case Rank::vector: return "vector";
        case Rank::matrix: return "matrix";
        case Rank::integer: return "whole number";
    }
    return "";
}

}  // namespace

void registerFields(input::Registry& registry) {
    const input::UnitSystem si;
    for (const FieldInfo* info : fields::all()) {
        const std::string unit = si.text(info->unit);
        registry.declare<NoParameters>(input::Kind::field, std::string(info->name))
            .summary(fmt::format("{} ({}{})", info->doc, rankName(info->rank),
                                 unit.empty() ? "" : ", " + unit));
    }
}

}  // namespace sphinx::particles
