// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"
#include "input/declaration/registry.h"
#include "materials/material.h"

#include <functional>
#include <memory>
#include <optional>

namespace sphinx::materials {

/// A rule about each particle of a body of the material, at its place in the reference
/// configuration, asked before the particles are made.
struct PlaceRule {
    using Violation = std::optional<MaterialViolation>;
    Violation (*in2d)(const void* parameters, const Vec<2>& place);
    Violation (*in3d)(const void* parameters, const Vec<3>& place);

    Violation check(const void* p, const Vec<2>& place) const { return in2d(p, place); }
    Violation check(const void* p, const Vec<3>& place) const { return in3d(p, place); }
};

/// What Declaration::builder of Kind::material holds.
struct MaterialBuilder {
    std::function<std::shared_ptr<const Material>(const void* parameters)> make;
    std::optional<PlaceRule> place_rule = {};
};

/// Declares every material.
void registerMaterials(input::Registry& registry);
/// The part of it that is ElasticSolid.
void registerElasticSolids(input::Registry& registry);

}  // namespace sphinx::materials
