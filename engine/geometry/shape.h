// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/types.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// Regions of the plane and of space. All lengths are in case units, all angles in radian.
namespace sphinx::geometry {

/// A shape that cannot be made (self-intersecting polygon, offset that vanishes, unreadable file).
/// The message names what is wrong and what would be right, without place: the caller adds it.
struct ShapeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Abscissa of point `k` of a row. One rounding, spelled out, so that no compiler option can make
/// the points of a row differ from the same points asked one by one.
inline double rowAbscissa(double first, double step, std::size_t k) {
    return std::fma(static_cast<double>(k), step, first);
}

/// A region of space. Immutable once made; all queries are thread-safe.
///
/// Regions are closed: their boundary belongs to them, and so the surface of a subtracted shape
/// belongs to the difference. In 2D the answer is exact for the polygon as stored in doubles.
template <int Dim>
class Shape {
 public:
    virtual ~Shape() = default;

    /// True inside and on the boundary; the same as signedDistance(point) <= 0.
    virtual bool contains(const Vec<Dim>& point) const = 0;
    /// Distance to the boundary, negative inside, infinite for an empty shape. Length.
    /// Booleans in 3D give the right sign and a value that never exceeds the true distance in size.
    virtual double signedDistance(const Vec<Dim>& point) const = 0;
    /// Unit vector of steepest increase of the signed distance: outwards. Where several directions
    /// are equal (a corner, the centre of a ball), their mean or a fixed one of them; zero for an
    /// empty shape.
    virtual Vec<Dim> normal(const Vec<Dim>& point) const = 0;
    /// Encloses the shape; tight in 2D and for primitives.
    virtual Box<Dim> bounds() const = 0;
    /// Nothing inside. A 3D difference that takes everything away is not noticed.
    virtual bool empty() const = 0;
    /// Area in 2D, volume in 3D (length^Dim); NaN for booleans in 3D, which have no closed form.
    virtual double measure() const { return nan_value; }

    /// inside[k] = contains(first, with its x replaced by rowAbscissa(first.x(), step, k)) for
    /// k < count. Polygons answer a whole row at once.
    virtual void rowContains(const Vec<Dim>& first, double step, std::size_t count,
                             std::uint8_t* inside) const;
};

template <int Dim>
using ShapePointer = std::shared_ptr<const Shape<Dim>>;

// Every function below throws ShapeError for arguments that make no shape.

// Primitives.
template <int Dim>
ShapePointer<Dim> makeBox(const Vec<Dim>& lower, const Vec<Dim>& upper);
/// Circle (2D) or sphere (3D). A circle stays exact until it enters a boolean, which takes it as
/// the regular polygon of equal area with 2048 corners (radius right to 8e-7).
template <int Dim>
ShapePointer<Dim> makeBall(const Vec<Dim>& center, double radius);
/// Simple polygon, either orientation, last point not repeated.
ShapePointer<2> makePolygon(const std::vector<Vec<2>>& points);
/// Polygon read from a file: WKT POLYGON/MULTIPOLYGON (with holes), or text/CSV with one "x y" or
/// "x,y" a line (blank lines, lines starting with '#' and one line of column names are skipped; a
/// last point equal to the first is dropped).
ShapePointer<2> readPolygon(const std::string& path);
/// Solid cylinder between the centres of its two end faces.
ShapePointer<3> makeCylinder(const Vec<3>& from, const Vec<3>& to, double radius);
/// Ring about an axis: a circle of `radius`, its centre so far from `center` as `ring_radius` says,
/// goes round once. The ring radius is the larger one.
ShapePointer<3> makeTorus(const Vec<3>& center, const Vec<3>& axis, double ring_radius,
                          double radius);

// Booleans: exact in 2D (CGAL), by signed distance in 3D.
template <int Dim>
ShapePointer<Dim> makeUnion(const std::vector<ShapePointer<Dim>>& shapes);
/// First minus all others.
template <int Dim>
ShapePointer<Dim> makeDifference(const std::vector<ShapePointer<Dim>>& shapes);
template <int Dim>
ShapePointer<Dim> makeIntersection(const std::vector<ShapePointer<Dim>>& shapes);
/// Grown (by > 0) or shrunk (by < 0). Edges and faces move parallel to themselves, so corners stay
/// sharp (mitred): in 2D, and for boxes and cylinders in 3D, booleans of them included. A 2D corner
/// below 11.5 degrees is cut off where its mitre would reach further than 10 offsets.
template <int Dim>
ShapePointer<Dim> makeOffset(const ShapePointer<Dim>& shape, double by);

// Transforms.
template <int Dim>
ShapePointer<Dim> makeTranslated(const ShapePointer<Dim>& shape, const Vec<Dim>& by);
/// Rotation by `angle` (radian, counter-clockwise) about `center`; in 3D about the axis through it.
/// Quarter turns are exact.
ShapePointer<2> makeRotated(const ShapePointer<2>& shape, double angle, const Vec<2>& center);
ShapePointer<3> makeRotated(const ShapePointer<3>& shape, double angle, const Vec<3>& center,
                            const Vec<3>& axis);
/// Enlarged by `factor` > 0, `center` fixed.
template <int Dim>
ShapePointer<Dim> makeScaled(const ShapePointer<Dim>& shape, double factor, const Vec<Dim>& center);
/// Mirror image at the line or plane through `point` with the given normal (any length).
template <int Dim>
ShapePointer<Dim> makeMirrored(const ShapePointer<Dim>& shape, const Vec<Dim>& point,
                               const Vec<Dim>& normal);

}  // namespace sphinx::geometry
