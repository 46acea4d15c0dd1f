// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>

namespace sphinx {

/// Physical dimension as exponents of length, time and mass. In 2D a quantity keeps its 3D
/// dimension and stands for a slice of unit depth (density kg/m3, force per metre of depth).
struct Dimension {
    int length = 0;
    int time = 0;
    int mass = 0;

    constexpr auto operator<=>(const Dimension&) const = default;
    constexpr Dimension operator*(const Dimension& o) const {
        return {length + o.length, time + o.time, mass + o.mass};
    }
    constexpr Dimension operator/(const Dimension& o) const {
        return {length - o.length, time - o.time, mass - o.mass};
    }
};

namespace unit {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0};
inline constexpr Dimension time{0, 1, 0};
inline constexpr Dimension mass{0, 0, 1};
inline constexpr Dimension area{2, 0, 0};
inline constexpr Dimension volume{3, 0, 0};
inline constexpr Dimension velocity{1, -1, 0};
inline constexpr Dimension acceleration{1, -2, 0};
inline constexpr Dimension frequency{0, -1, 0};
inline constexpr Dimension density{-3, 0, 1};
inline constexpr Dimension density_rate{-3, -1, 1};
inline constexpr Dimension mass_rate{0, -1, 1};
inline constexpr Dimension number_density{-3, 0, 0};
inline constexpr Dimension pressure{-1, -2, 1};
inline constexpr Dimension dynamic_viscosity{-1, -1, 1};
inline constexpr Dimension kinematic_viscosity{2, -1, 0};
inline constexpr Dimension force{1, -2, 1};
inline constexpr Dimension momentum{1, -1, 1};
inline constexpr Dimension energy{2, -2, 1};
}  // namespace unit

}  // namespace sphinx
