// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/language/shapes.h"

#include <functional>

namespace sphinx::language {

/// Turns expressions into shapes; a named shape is made once.
template <int Dim>
class ShapeMaker {
 public:
    ShapeMaker(const std::vector<NamedShape>& shapes, input::Diagnostics& diagnostics)
        : shapes_(shapes), diagnostics_(diagnostics) {}

    /// nullptr, after a report, when it cannot be made.
    geometry::ShapePointer<Dim> make(const ShapeExpression& expression);
    geometry::ShapePointer<Dim> make(const NamedShape& shape);

    /// For the builders of shapes: throws Failed when an operand cannot be made.
    geometry::ShapePointer<Dim> operand(const SharedShapeExpression& expression);
    std::vector<geometry::ShapePointer<Dim>> operands(
        const std::vector<SharedShapeExpression>& expressions);
    struct Failed {};

 private:
    const std::vector<NamedShape>& shapes_;
    input::Diagnostics& diagnostics_;
    std::map<std::string, geometry::ShapePointer<Dim>> made_;
    std::vector<std::string> busy_;
};

/// What a declaration of Kind::shape holds as its builder; empty for a dimension without the shape.
struct ShapeBuilder {
    std::function<geometry::ShapePointer<2>(const void* parameters, ShapeMaker<2>&)> in2d;
    std::function<geometry::ShapePointer<3>(const void* parameters, ShapeMaker<3>&)> in3d;
};

}  // namespace sphinx::language
