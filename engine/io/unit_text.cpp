// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/unit_text.h"

namespace sphinx::io {

std::string unitText(const Dimension& dimension, const input::UnitSystem& units) {
    if (units.none || dimension == unit::none) return "";
    if (units.length == "m" && units.time == "s" && units.mass == "kg") {
        if (dimension == unit::pressure) return "Pa";
        if (dimension == unit::force) return "N";
        if (dimension == unit::energy) return "J";
    }
    return units.name(dimension);
}

}  // namespace sphinx::io
