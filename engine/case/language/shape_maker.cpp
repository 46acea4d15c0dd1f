// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/shape_maker.h"

#include <algorithm>

namespace sphinx::language {

template <int Dim>
geometry::ShapePointer<Dim> ShapeMaker<Dim>::make(const ShapeExpression& expression) {
    if (!expression.declaration) {
        for (const NamedShape& shape : shapes_)
            if (shape.name == expression.reference.text) {
                if (std::find(busy_.begin(), busy_.end(), shape.name) == busy_.end())
                    return make(shape);
                std::string cycle;
                for (const std::string& name : busy_) cycle += name + " -> ";
                diagnostics_.error(expression.place,
                                   "the shapes are made of each other: " + cycle + shape.name);
                return nullptr;
            }
        return nullptr;  // reported with the names
    }
    const auto& builder = expression.declaration->builder<ShapeBuilder>();
    const auto& build = [&]() -> const auto& {
        if constexpr (Dim == 2)
            return builder.in2d;
        else
            return builder.in3d;
    }
    ();
    const std::string& name = expression.declaration->name();
    if (!build) {
        diagnostics_.error(expression.place, name + " exists in " + (Dim == 2 ? "3D" : "2D") +
                                                 " only, and the case is " +
                                                 (Dim == 2 ? "2D" : "3D"));
        return nullptr;
    }
    try {
        return build(expression.parameters.get(), *this);
    } catch (const geometry::ShapeError& e) {
        diagnostics_.error(expression.place, name + ": " + e.what());
    } catch (const Failed&) {
    }
    return nullptr;
}

template <int Dim>
geometry::ShapePointer<Dim> ShapeMaker<Dim>::make(const NamedShape& shape) {
    if (const auto found = made_.find(shape.name); found != made_.end()) return found->second;
    busy_.push_back(shape.name);
    auto made = shape.expression ? make(*shape.expression) : nullptr;
    busy_.pop_back();
    return made_[shape.name] = std::move(made);
}

template <int Dim>
geometry::ShapePointer<Dim> ShapeMaker<Dim>::operand(const SharedShapeExpression& expression) {
    auto shape = make(*expression);
    if (!shape) throw Failed{};
    return shape;
}

template <int Dim>
std::vector<geometry::ShapePointer<Dim>> ShapeMaker<Dim>::operands(
    const std::vector<SharedShapeExpression>& expressions) {
    std::vector<geometry::ShapePointer<Dim>> shapes;
    for (const SharedShapeExpression& expression : expressions)
        shapes.push_back(operand(expression));
    return shapes;
}

template class ShapeMaker<2>;
template class ShapeMaker<3>;

std::vector<model::Shape> buildShapes(const std::vector<NamedShape>& shapes, int dimension,
                                      input::Diagnostics& diagnostics) {
    std::vector<model::Shape> built;
    ShapeMaker<2> maker2(shapes, diagnostics);
    ShapeMaker<3> maker3(shapes, diagnostics);
    for (const NamedShape& shape : shapes) {
        model::Shape& result = built.emplace_back();
        result.name = shape.name;
        result.place = shape.place;
        if (dimension == 2)
            result.shape2 = maker2.make(shape);
        else
            result.shape3 = maker3.make(shape);
    }
    return built;
}

}  // namespace sphinx::language
