// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/shape_maker.h"

namespace sphinx::language {
namespace {

using namespace input;
using Shapes = std::vector<SharedShapeExpression>;

struct BoxParameters {
    Coordinates lower, upper;
};
struct BallParameters {
    Coordinates center;
    double radius = 0;
};
struct PolygonParameters {
    Table points;
};
struct CylinderParameters {
    Coordinates from, to;
    double radius = 0;
};
struct TorusParameters {
    Coordinates center, axis;
    double ring_radius = 0;
    double radius = 0;
};
struct CombinationParameters {
    Shapes shapes;
};
struct OffsetParameters {
    SharedShapeExpression shape;
    double by = 0;
};
struct TranslateParameters {
    SharedShapeExpression shape;
    Coordinates by;
};
struct RotateParameters {
    SharedShapeExpression shape;
    double angle = 0;
    Coordinates center, axis;
};
struct ScaleParameters {
    SharedShapeExpression shape;
    double factor = 1;
    Coordinates center;
};
struct MirrorParameters {
    SharedShapeExpression shape;
    Coordinates point, normal;
};

template <int Dim>
Vec<Dim> vector(const Coordinates& c) {
    return c.size == 0 ? Vec<Dim>(Vec<Dim>::Zero()) : c.as<Dim>();
}

/// make: []<int Dim>(const P&, ShapeMaker<Dim>&).
template <class P, class Make>
ShapeBuilder bothDimensions(Make make) {
    return {[make](const void* p, ShapeMaker<2>& maker) {
                return make.template operator()<2>(*static_cast<const P*>(p), maker);
            },
            [make](const void* p, ShapeMaker<3>& maker) {
                return make.template operator()<3>(*static_cast<const P*>(p), maker);
            }};
}

/// make: [](const P&), in one dimension only.
template <int Dim, class P, class Make>
ShapeBuilder only(Make make) {
    ShapeBuilder builder;
    const auto build = [make](const void* p, ShapeMaker<Dim>&) {
        return make(*static_cast<const P*>(p));
    };
    if constexpr (Dim == 2)
        builder.in2d = build;
    else
        builder.in3d = build;
    return builder;
}

void declareBox(Registry& registry) {
    using P = BoxParameters;
    auto& d = registry.declare<P>(Kind::shape, "box");
    d.summary("Rectangle or box along the axes");
    d.required("lower", &P::lower, coordinates(unit::length), "corner of the smallest coordinates");
    d.required("upper", &P::upper, coordinates(unit::length), "corner of the largest coordinates");
    d.builder(bothDimensions<P>([]<int Dim>(const P& p, ShapeMaker<Dim>&) {
        return geometry::makeBox<Dim>(p.lower.as<Dim>(), p.upper.as<Dim>());
    }));
}

template <int Dim>
void declareBall(Registry& registry, const char* name, const char* summary) {
    using P = BallParameters;
    auto& d = registry.declare<P>(Kind::shape, name);
    d.summary(summary);
    d.optional("center", &P::center, coordinates(unit::length), "centre; default: the origin");
    d.required("radius", &P::radius, number(unit::length).above(0), "radius");
    d.builder(only<Dim, P>(
        [](const P& p) { return geometry::makeBall<Dim>(vector<Dim>(p.center), p.radius); }));
}

void declarePolygon(Registry& registry) {
    using P = PolygonParameters;
    auto& d = registry.declare<P>(Kind::shape, "polygon");
    d.summary("Simple polygon (2D): corners in either order, or a file with WKT or one x y a line");
    d.bareValue(&P::points, tableOrFile(unit::length), "corners, the last not the first again");
    d.builder(only<2, P>([](const P& p) {
        if (!p.points.file.empty()) return geometry::readPolygon(p.points.file);
        std::vector<Vec<2>> corners;
        for (const auto& row : p.points.rows) corners.emplace_back(row[0], row[1]);
        return geometry::makePolygon(corners);
    }));
}

void declareCylinder(Registry& registry) {
    using P = CylinderParameters;
    auto& d = registry.declare<P>(Kind::shape, "cylinder");
    d.summary("Solid cylinder (3D)");
    d.required("from", &P::from, coordinates(unit::length), "centre of one end face");
    d.required("to", &P::to, coordinates(unit::length), "centre of the other end face");
    d.required("radius", &P::radius, number(unit::length).above(0), "radius");
    d.builder(only<3, P>(
        [](const P& p) { return geometry::makeCylinder(p.from.as<3>(), p.to.as<3>(), p.radius); }));
}

void declareTorus(Registry& registry) {
    using P = TorusParameters;
    auto& d = registry.declare<P>(Kind::shape, "torus");
    d.summary("Torus (3D): a circle that goes round an axis outside of it");
    d.optional("center", &P::center, coordinates(unit::length), "centre; default: the origin");
    d.required("axis", &P::axis, coordinates(unit::none), "direction of the axis");
    d.required("ring_radius", &P::ring_radius, number(unit::length).above(0),
               "from the axis to the middle of the circle");
    d.required("radius", &P::radius, number(unit::length).above(0), "of the circle");
    d.builder(only<3, P>([](const P& p) {
        return geometry::makeTorus(vector<3>(p.center), p.axis.as<3>(), p.ring_radius, p.radius);
    }));
}

template <class Make>
void declareCombination(Registry& registry, const char* name, const char* summary, Make make) {
    using P = CombinationParameters;
    auto& d = registry.declare<P>(Kind::shape, name);
    d.summary(summary);
    d.bareValue(&P::shapes, list(shapeExpression()), "shapes or their names");
    d.check("", [](const P& p) {
        return p.shapes.empty() ? std::string("at least one shape is needed") : std::string();
    });
    d.builder(bothDimensions<P>([make]<int Dim>(const P& p, ShapeMaker<Dim>& maker) {
        return make(maker.operands(p.shapes));
    }));
}

void declareTransforms(Registry& registry) {
    {
        using P = OffsetParameters;
        auto& d = registry.declare<P>(Kind::shape, "offset");
        d.summary("A shape grown (by above 0) or shrunk, with sharp corners");
        d.required("shape", &P::shape, shapeExpression(), "what is grown");
        d.required("by", &P::by, number(unit::length), "distance of the new boundary");
        d.builder(bothDimensions<P>([]<int Dim>(const P& p, ShapeMaker<Dim>& maker) {
            return geometry::makeOffset<Dim>(maker.operand(p.shape), p.by);
        }));
    }
    {
        using P = TranslateParameters;
        auto& d = registry.declare<P>(Kind::shape, "translate");
        d.summary("A shape moved");
        d.required("shape", &P::shape, shapeExpression(), "what is moved");
        d.required("by", &P::by, coordinates(unit::length), "displacement");
        d.builder(bothDimensions<P>([]<int Dim>(const P& p, ShapeMaker<Dim>& maker) {
            return geometry::makeTranslated<Dim>(maker.operand(p.shape), p.by.as<Dim>());
        }));
    }
    {
        using P = RotateParameters;
        auto& d = registry.declare<P>(Kind::shape, "rotate");
        d.summary("A shape turned counter-clockwise about a point, in 3D about an axis through it");
        d.required("shape", &P::shape, shapeExpression(), "what is turned");
        d.required("angle", &P::angle, number(unit::none), "angle in radian, or such as 30 deg");
        d.optional("center", &P::center, coordinates(unit::length),
                   "point that stays; default: the origin");
        d.optional("axis", &P::axis, coordinates(unit::none), "direction of the axis, in 3D only");
        d.check("axis", [](const P& p) -> std::string {
            const int dimension = p.axis.size;
            return dimension == 2 ? "a rotation in 2D has no axis" : "";
        });
        d.builder(bothDimensions<P>([]<int Dim>(const P& p, ShapeMaker<Dim>& maker) {
            if (Dim == 3 && p.axis.size == 0) throw geometry::ShapeError("in 3D an axis is needed");
            const auto shape = maker.operand(p.shape);
            const Vec<Dim> center = vector<Dim>(p.center);
            if constexpr (Dim == 2)
                return geometry::makeRotated(shape, p.angle, center);
            else
                return geometry::makeRotated(shape, p.angle, center, p.axis.as<3>());
        }));
    }
    {
        using P = ScaleParameters;
        auto& d = registry.declare<P>(Kind::shape, "scale");
        d.summary("A shape enlarged or reduced about a point");
        d.required("shape", &P::shape, shapeExpression(), "what is scaled");
        d.required("factor", &P::factor, number(unit::none).above(0), "factor of every length");
        d.optional("center", &P::center, coordinates(unit::length),
                   "point that stays; default: the origin");
        d.builder(bothDimensions<P>([]<int Dim>(const P& p, ShapeMaker<Dim>& maker) {
            return geometry::makeScaled<Dim>(maker.operand(p.shape), p.factor,
                                             vector<Dim>(p.center));
        }));
    }
    {
        using P = MirrorParameters;
        auto& d = registry.declare<P>(Kind::shape, "mirror");
        d.summary("Mirror image of a shape at a line or plane");
        d.required("shape", &P::shape, shapeExpression(), "what is mirrored");
        d.optional("point", &P::point, coordinates(unit::length),
                   "a point of the line or plane; default: the origin");
        d.required("normal", &P::normal, coordinates(unit::none), "normal of the line or plane");
        d.builder(bothDimensions<P>([]<int Dim>(const P& p, ShapeMaker<Dim>& maker) {
            return geometry::makeMirrored<Dim>(maker.operand(p.shape), vector<Dim>(p.point),
                                               p.normal.as<Dim>());
        }));
    }
}

}  // namespace

void registerShapes(Registry& registry) {
    declareBox(registry);
    declareBall<2>(registry, "circle", "Circle (2D)");
    declareBall<3>(registry, "sphere", "Sphere (3D)");
    declarePolygon(registry);
    declareCylinder(registry);
    declareTorus(registry);
    declareCombination(registry, "union", "All of several shapes",
                       [](const auto& shapes) { return geometry::makeUnion(shapes); });
    declareCombination(registry, "difference", "The first shape without the others",
                       [](const auto& shapes) { return geometry::makeDifference(shapes); });
    declareCombination(registry, "intersection", "What several shapes have in common",
                       [](const auto& shapes) { return geometry::makeIntersection(shapes); });
    declareTransforms(registry);
}

}  // namespace sphinx::language
