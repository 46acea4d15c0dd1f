// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "materials/material.h"

#include <functional>
#include <memory>

namespace sphinx {

/// What Declaration::builder of Kind::material holds.
using MaterialFactory = std::function<std::shared_ptr<const Material>(const void* parameters)>;

/// Declares every material.
void registerMaterials(input::Registry& registry);
/// The part of it that is ElasticSolid.
void registerElasticSolids(input::Registry& registry);

}  // namespace sphinx
