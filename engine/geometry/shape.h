// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace sphinx::geometry {

/// A shape that cannot be made (self-intersecting polygon, offset that vanishes, unreadable file...).
/// The message names what is wrong and what would be right, without place: the caller adds it.
struct ShapeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A region of space. Immutable once made; all queries are thread-safe.
template <int Dim>
class Shape {
   public:
    virtual ~Shape() = default;

    /// True inside and on the boundary.
    virtual bool contains(const Vec<Dim>& point) const = 0;
    /// Distance to the boundary, negative inside. Length, case units.
    virtual double signedDistance(const Vec<Dim>& point) const = 0;
    /// Unit vector of steepest increase of the signed distance: outwards.
    virtual Vec<Dim> normal(const Vec<Dim>& point) const = 0;
    virtual Box<Dim> bounds() const = 0;
    virtual bool empty() const = 0;

    /// inside[k] = contains(first + k step e_x) for k < count. Polygons answer a whole row at once.
    virtual void rowContains(const Vec<Dim>& first, double step, std::size_t count,
                             std::uint8_t* inside) const;
};

template <int Dim>
using ShapePointer = std::shared_ptr<const Shape<Dim>>;

// Primitives.
template <int Dim>
ShapePointer<Dim> makeBox(const Vec<Dim>& lower, const Vec<Dim>& upper);
/// Circle (2D) or sphere (3D).
template <int Dim>
ShapePointer<Dim> makeBall(const Vec<Dim>& center, double radius);
/// Simple polygon, either orientation, last point not repeated.
ShapePointer<2> makePolygon(const std::vector<Vec<2>>& points);
/// Polygon read from a file: WKT POLYGON/MULTIPOLYGON (with holes), or text/CSV with one "x y" or "x,y" a line.
ShapePointer<2> readPolygon(const std::string& path);
/// Solid cylinder between the centres of its two end faces.
ShapePointer<3> makeCylinder(const Vec<3>& from, const Vec<3>& to, double radius);

// Booleans: exact in 2D (CGAL), by signed distance in 3D.
template <int Dim>
ShapePointer<Dim> makeUnion(const std::vector<ShapePointer<Dim>>& shapes);
/// First minus all others.
template <int Dim>
ShapePointer<Dim> makeDifference(const std::vector<ShapePointer<Dim>>& shapes);
template <int Dim>
ShapePointer<Dim> makeIntersection(const std::vector<ShapePointer<Dim>>& shapes);
/// Grown (by > 0) or shrunk (by < 0); corners mitred in 2D.
template <int Dim>
ShapePointer<Dim> makeOffset(const ShapePointer<Dim>& shape, double by);

// Transforms.
template <int Dim>
ShapePointer<Dim> makeTranslated(const ShapePointer<Dim>& shape, const Vec<Dim>& by);
/// Rotation by `angle` (radian, counter-clockwise) about `center`; in 3D about the axis through it.
ShapePointer<2> makeRotated(const ShapePointer<2>& shape, double angle, const Vec<2>& center);
ShapePointer<3> makeRotated(const ShapePointer<3>& shape, double angle, const Vec<3>& center,
                            const Vec<3>& axis);
template <int Dim>
ShapePointer<Dim> makeScaled(const ShapePointer<Dim>& shape, double factor, const Vec<Dim>& center);
/// Mirror image at the plane through `point` with the given normal (any length).
template <int Dim>
ShapePointer<Dim> makeMirrored(const ShapePointer<Dim>& shape, const Vec<Dim>& point,
                               const Vec<Dim>& normal);

}  // namespace sphinx::geometry
