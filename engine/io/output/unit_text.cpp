// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/output/unit_text.h"

namespace sphinx::io {

std::string unitText(const Dimension& dimension, const input::UnitSystem& units) {
    return units.text(dimension);
}

}  // namespace sphinx::io
