// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/language/register.h"

#include <string>

namespace sphinx::test {

/// Everything that a case can name.
inline const input::Registry& registry() {
    static const input::Registry& all = []() -> input::Registry& {
        auto* made = new input::Registry;
        language::registerAll(*made);
        return *made;
    }();
    return all;
}

/// A case up to its methods: a block of water. `version`: of the language.
inline std::string blockOfWater(int version) {
    return "sphinx: " + std::to_string(version) + R"yaml(
dimension: 2
units: none
resolution: {spacing: 0.1, smoothing_ratio: 1.3}
geometry: {block: {box: {lower: [0, 0], upper: [1, 1]}}}
materials: {water: {type: weakly_compressible_fluid, density: 1, sound_speed: 10}}
bodies: {water: {kind: fluid, shape: block, material: water}}
topology: {water: [self]}
)yaml";
}

}  // namespace sphinx::test
