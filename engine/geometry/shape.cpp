// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/shape.h"

#include "geometry/combination.h"
#include "geometry/disc.h"
#include "geometry/overlay.h"
#include "geometry/polygon.h"
#include "geometry/solids.h"

#include <fmt/format.h>

namespace sphinx::geometry {
namespace {

template <int Dim>
std::string text(const Vec<Dim>& p) {
    return fmt::format("({})", fmt::join(p.data(), p.data() + Dim, ", "));
}

template <int Dim>
void requireFinite(const char* what, const Vec<Dim>& p) {
    if (!p.allFinite()) throw ShapeError(fmt::format("{} {} must be finite", what, text<Dim>(p)));
}

void requirePositive(const char* what, double value) {
    if (!(value > 0 && std::isfinite(value))) {
        throw ShapeError(fmt::format("{} is {} but must be above 0", what, value));
    }
}

template <int Dim>
ShapePointer<Dim> combine(const char* name, Rule rule,
                          const std::vector<ShapePointer<Dim>>& shapes) {
    if (shapes.empty()) throw ShapeError(fmt::format("{} needs at least one shape", name));
    if (shapes.size() == 1) return shapes.front();
    if constexpr (Dim == 2) {
        std::vector<Rings> operands;
        for (const ShapePointer<2>& shape : shapes) {
            operands.push_back(dynamic_cast<const Region&>(*shape).rings());
        }
        return std::make_shared<Polygon>(overlay(operands, rule));
    } else {
        return std::make_shared<Combination>(rule, shapes);
    }
}

}  // namespace

template <int Dim>
void Shape<Dim>::rowContains(const Vec<Dim>& first, double step, std::size_t count,
                             std::uint8_t* inside) const {
    Vec<Dim> point = first;
    for (std::size_t k = 0; k < count; ++k) {
        point.x() = rowAbscissa(first.x(), step, k);
        inside[k] = contains(point);
    }
}

template <int Dim>
ShapePointer<Dim> makeBox(const Vec<Dim>& lower, const Vec<Dim>& upper) {
    requireFinite<Dim>("lower corner", lower);
    requireFinite<Dim>("upper corner", upper);
    for (int i = 0; i < Dim; ++i) {
        if (!(lower[i] < upper[i])) {
            throw ShapeError(
                fmt::format("the box has no extent along {}: its upper corner {} must lie "
                            "above its lower corner {} in every coordinate",
                            "xyz"[i], text<Dim>(upper), text<Dim>(lower)));
        }
    }
    if constexpr (Dim == 2) {
        return std::make_shared<Polygon>(
            Rings{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}});
    } else {
        return std::make_shared<BoxSolid>(lower, upper);
    }
}

template <int Dim>
ShapePointer<Dim> makeBall(const Vec<Dim>& center, double radius) {
    requireFinite<Dim>("center", center);
    requirePositive("radius", radius);
    if constexpr (Dim == 2) {
        return std::make_shared<Disc>(center, radius);
    } else {
        return std::make_shared<Ball>(center, radius);
    }
}

ShapePointer<2> makePolygon(const std::vector<Vec<2>>& points) {
    return std::make_shared<Polygon>(Rings{simpleRing(points, "")});
}

ShapePointer<3> makeCylinder(const Vec<3>& from, const Vec<3>& to, double radius) {
    requireFinite<3>("end", from);
    requireFinite<3>("end", to);
    if (from == to) {
        throw ShapeError(fmt::format("the ends of the cylinder coincide at {}", text<3>(from)));
    }
    requirePositive("radius", radius);
    return std::make_shared<Cylinder>(from, to, radius);
}

ShapePointer<3> makeTorus(const Vec<3>& center, const Vec<3>& axis, double ring_radius,
                          double radius) {
    requireFinite<3>("center", center);
    requireFinite<3>("axis", axis);
    if (!(axis.norm() > 0)) throw ShapeError("the axis of a torus must not be zero");
    requirePositive("ring_radius", ring_radius);
    requirePositive("radius", radius);
    if (!(radius < ring_radius))
        throw ShapeError(fmt::format(
            "radius is {} but must be below ring_radius, {}, so that the torus has a hole", radius,
            ring_radius));
    return std::make_shared<Torus>(center, axis, ring_radius, radius);
}

template <int Dim>
ShapePointer<Dim> makeUnion(const std::vector<ShapePointer<Dim>>& shapes) {
    return combine("a union", Rule::any, shapes);
}

template <int Dim>
ShapePointer<Dim> makeDifference(const std::vector<ShapePointer<Dim>>& shapes) {
    return combine("a difference", Rule::first_not_rest, shapes);
}

template <int Dim>
ShapePointer<Dim> makeIntersection(const std::vector<ShapePointer<Dim>>& shapes) {
    return combine("an intersection", Rule::all, shapes);
}

template <int Dim>
ShapePointer<Dim> makeOffset(const ShapePointer<Dim>& shape, double by) {
    if (!std::isfinite(by)) throw ShapeError(fmt::format("offset {} must be finite", by));
    if (shape->empty()) throw ShapeError("an empty shape cannot be offset");
    ShapePointer<Dim> result = composable(shape).grown(by);
    if (!result) {
        const Vec<Dim> size = shape->bounds().size();
        throw ShapeError(fmt::format("offset {} leaves nothing of a shape of size {}", by,
                                     fmt::join(size.data(), size.data() + Dim, " x ")));
    }
    return result;
}

template <int Dim>
ShapePointer<Dim> makeTranslated(const ShapePointer<Dim>& shape, const Vec<Dim>& by) {
    requireFinite<Dim>("translation", by);
    return composable(shape).transformed(translation<Dim>(by));
}

ShapePointer<2> makeRotated(const ShapePointer<2>& shape, double angle, const Vec<2>& center) {
    if (!std::isfinite(angle)) throw ShapeError(fmt::format("angle {} must be finite", angle));
    requireFinite<2>("center", center);
    return composable(shape).transformed(rotation(angle, center));
}

ShapePointer<3> makeRotated(const ShapePointer<3>& shape, double angle, const Vec<3>& center,
                            const Vec<3>& axis) {
    if (!std::isfinite(angle)) throw ShapeError(fmt::format("angle {} must be finite", angle));
    requireFinite<3>("center", center);
    requireFinite<3>("axis", axis);
    if (!(axis.norm() > 0)) throw ShapeError("the axis of a rotation must not be zero");
    return composable(shape).transformed(rotation(angle, center, axis));
}

template <int Dim>
ShapePointer<Dim> makeScaled(const ShapePointer<Dim>& shape, double factor,
                             const Vec<Dim>& center) {
    requirePositive("factor", factor);
    requireFinite<Dim>("center", center);
    return composable(shape).transformed(scaling<Dim>(factor, center));
}

template <int Dim>
ShapePointer<Dim> makeMirrored(const ShapePointer<Dim>& shape, const Vec<Dim>& point,
                               const Vec<Dim>& normal) {
    requireFinite<Dim>("point", point);
    requireFinite<Dim>("normal", normal);
    if (!(normal.norm() > 0)) throw ShapeError("the normal of a mirror must not be zero");
    return composable(shape).transformed(mirror<Dim>(point, normal));
}

#define SPHINX_INSTANTIATE(Dim)                                                               \
    template class Shape<Dim>;                                                                \
    template ShapePointer<Dim> makeBox(const Vec<Dim>&, const Vec<Dim>&);                     \
    template ShapePointer<Dim> makeBall(const Vec<Dim>&, double);                             \
    template ShapePointer<Dim> makeUnion(const std::vector<ShapePointer<Dim>>&);              \
    template ShapePointer<Dim> makeDifference(const std::vector<ShapePointer<Dim>>&);         \
    template ShapePointer<Dim> makeIntersection(const std::vector<ShapePointer<Dim>>&);       \
    template ShapePointer<Dim> makeOffset(const ShapePointer<Dim>&, double);                  \
    template ShapePointer<Dim> makeTranslated(const ShapePointer<Dim>&, const Vec<Dim>&);     \
    template ShapePointer<Dim> makeScaled(const ShapePointer<Dim>&, double, const Vec<Dim>&); \
    template ShapePointer<Dim> makeMirrored(const ShapePointer<Dim>&, const Vec<Dim>&,        \
                                            const Vec<Dim>&);
SPHINX_INSTANTIATE(2)
SPHINX_INSTANTIATE(3)
#undef SPHINX_INSTANTIATE

}  // namespace sphinx::geometry
