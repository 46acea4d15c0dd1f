// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "particles/field.h"

#include <vector>

namespace sphinx {

/// Every field of the program: name, rank, unit and meaning in one place.
namespace fields {

inline constexpr FieldInfo id{"id", Rank::integer, unit::none, "stable number of the particle"};
inline constexpr FieldInfo position{"position", Rank::vector, unit::length, "current position"};
inline constexpr FieldInfo velocity{"velocity", Rank::vector, unit::velocity, "velocity"};
inline constexpr FieldInfo mass{"mass", Rank::scalar, unit::mass,
                                "mass (2D: of a slice of unit depth)"};
inline constexpr FieldInfo volume{"volume", Rank::scalar, unit::volume,
                                  "volume (2D: of a slice of unit depth)"};
inline constexpr FieldInfo density{"density", Rank::scalar, unit::density, "density"};
inline constexpr FieldInfo density_rate{"density_rate", Rank::scalar, unit::density_rate,
                                        "rate of change of the density by the continuity equation"};
inline constexpr FieldInfo reference_density{
    "reference_density", Rank::scalar, unit::density, "density at the start, for confined flows"};
inline constexpr FieldInfo pressure{"pressure", Rank::scalar, unit::pressure, "pressure"};
inline constexpr FieldInfo acceleration{"acceleration", Rank::vector, unit::acceleration,
                                        "acceleration of a solid particle"};
inline constexpr FieldInfo external_acceleration{
    "external_acceleration", Rank::vector, unit::acceleration,
    "acceleration by all other forces (gravity, viscosity), held over a substep"};
inline constexpr FieldInfo normal{"normal", Rank::vector, unit::none,
                                  "outward unit normal of the body's surface"};
inline constexpr FieldInfo fibre{"fibre", Rank::vector, unit::none,
                                 "unit direction of the fibres in the reference configuration"};
inline constexpr FieldInfo sheet{"sheet", Rank::vector, unit::none,
                                 "unit direction of the sheets in the reference configuration"};
inline constexpr FieldInfo depth{"depth", Rank::scalar, unit::length,
                                 "distance of a solid particle from the body's surface"};

/// The field of that name, or nullptr.
const FieldInfo* find(std::string_view name);
/// All of them, in the order of declaration.
const std::vector<const FieldInfo*>& all();

}  // namespace fields
}  // namespace sphinx
