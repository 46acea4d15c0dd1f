// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "input/declaration/registry.h"
#include "input/tree/diagnostics.h"

#include <map>

namespace sphinx::language {

/// A shape as written: the name of an entry of `geometry`, or an inline one-key map.
struct ShapeExpression {
    input::Name reference;  ///< set, or:
    const input::Declaration* declaration = nullptr;
    std::shared_ptr<const void> parameters;
    input::Place place;
};

/// The block `geometry`, not yet built.
struct NamedShape {
    std::string name;
    input::Place place;
    std::shared_ptr<const ShapeExpression> expression;
};

using SharedShapeExpression = std::shared_ptr<const ShapeExpression>;

/// A shape or the name of one.
input::Type<SharedShapeExpression> shapeExpression();
input::Type<std::vector<NamedShape>> namedShapes();

void registerShapes(input::Registry& registry);

/// Makes the shapes of a case; whatever cannot be made is reported at its place.
std::vector<model::Shape> buildShapes(const std::vector<NamedShape>& shapes, int dimension,
                                      input::Diagnostics& diagnostics);

}  // namespace sphinx::language
