// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sphinx::geometry {
namespace {

/// Distance to a product of convex sets from the signed distances to each: outside, those beyond
/// add as at a right angle; inside, the nearest face counts.
template <int N>
double productDistance(const Vec<N>& beyond) {
    const double largest = beyond.maxCoeff();
    return largest > 0 ? beyond.cwiseMax(0.0).norm() : largest;
}

Vec<3> unitOrX(const Vec<3>& v) {
    const double length = v.norm();
    return length > 0 ? Vec<3>(v / length) : Vec<3>::UnitX();
}

}  // namespace

double BoxSolid::signedDistance(const Vec<3>& point) const {
    const Vec<3> q = toLocal(point);
    return productDistance<3>((local_.lower - q).cwiseMax(q - local_.upper));
}

Vec<3> BoxSolid::normal(const Vec<3>& point) const {
    const Vec<3> q = toLocal(point);
    const Vec<3> below = local_.lower - q, above = q - local_.upper;
    const Vec<3> beyond = below.cwiseMax(above);
    int nearest = 0;
    Vec<3> direction = Vec<3>::Zero();
    for (int i = 0; i < 3; ++i) {
        if (beyond[i] > beyond[nearest]) nearest = i;
        if (beyond[i] > 0) direction[i] = below[i] > above[i] ? -beyond[i] : beyond[i];
    }
    if (beyond[nearest] <= 0) direction[nearest] = below[nearest] > above[nearest] ? -1 : 1;
    return axes_ * direction.normalized();
}

Box<3> BoxSolid::bounds() const {
    Box<3> box;
    for (int corner = 0; corner < 8; ++corner) {
        Vec<3> q;
        for (int i = 0; i < 3; ++i) q[i] = corner >> i & 1 ? local_.upper[i] : local_.lower[i];
        box.include(origin_ + axes_ * q);
    }
    return box;
}

ShapePointer<3> BoxSolid::transformed(const Similarity<3>& map) const {
    if (axes_ == Mat<3>::Identity() && origin_.isZero(0) && map.keepsAxes()) {
        Box<3> box;
        box.include(map(local_.lower));
        box.include(map(local_.upper));
        return std::make_shared<BoxSolid>(box.lower, box.upper);
    }
    return std::make_shared<BoxSolid>(map.factor * local_.lower, map.factor * local_.upper,
                                      map.turn() * axes_, map(origin_));
}

ShapePointer<3> BoxSolid::grown(double by) const {
    const Vec<3> lower = local_.lower.array() - by, upper = local_.upper.array() + by;
    if ((lower.array() >= upper.array()).any()) return nullptr;
    return std::make_shared<BoxSolid>(lower, upper, axes_, origin_);
}

double Ball::signedDistance(const Vec<3>& point) const {
    return (point - center_).norm() - radius_;
}

Vec<3> Ball::normal(const Vec<3>& point) const { return unitOrX(point - center_); }

Box<3> Ball::bounds() const {
    return {center_ - Vec<3>::Constant(radius_), center_ + Vec<3>::Constant(radius_)};
}

ShapePointer<3> Ball::transformed(const Similarity<3>& map) const {
    return std::make_shared<Ball>(map(center_), map.factor * radius_);
}

ShapePointer<3> Ball::grown(double by) const {
    return radius_ + by > 0 ? std::make_shared<Ball>(center_, radius_ + by) : nullptr;
}

Cylinder::Place Cylinder::place(const Vec<3>& point) const {
    const Vec<3> from = point - from_, to = point - to_;
    const double height = from.dot(axis_), above = to.dot(axis_);
    const Vec<3> radial = from - height * axis_;
    const double distance = radial.norm();
    Place place;
    // On the axis any direction across it is as good: one that is never parallel to it.
    place.radial = distance > 0 ? Vec<3>(radial / distance) : axis_.unitOrthogonal();
    place.axial = above > -height ? axis_ : Vec<3>(-axis_);
    place.beyond_shell = distance - radius_;
    place.beyond_end = std::max(above, -height);
    return place;
}

double Cylinder::signedDistance(const Vec<3>& point) const {
    const Place p = place(point);
    return productDistance<2>({p.beyond_shell, p.beyond_end});
}

Vec<3> Cylinder::normal(const Vec<3>& point) const {
    const Place p = place(point);
    if (p.beyond_shell > 0 && p.beyond_end > 0) {
        return (p.beyond_shell * p.radial + p.beyond_end * p.axial).normalized();
    }
    return p.beyond_shell >= p.beyond_end ? p.radial : p.axial;
}

Box<3> Cylinder::bounds() const {
    // A disc across the unit axis a reaches r sqrt(1 - a_i^2) along coordinate i.
    const Vec<3> reach = radius_ * (1 - axis_.array().square()).max(0).sqrt();
    Box<3> box;
    for (const Vec<3>& end : {from_, to_}) {
        box.include(end - reach);
        box.include(end + reach);
    }
    return box;
}

ShapePointer<3> Cylinder::transformed(const Similarity<3>& map) const {
    return std::make_shared<Cylinder>(map(from_), map(to_), map.factor * radius_);
}

ShapePointer<3> Cylinder::grown(double by) const {
    if (radius_ + by <= 0 || (to_ - from_).norm() + 2 * by <= 0) return nullptr;
    return std::make_shared<Cylinder>(from_ - by * axis_, to_ + by * axis_, radius_ + by);
}

Vec<3> Torus::fromCore(const Vec<3>& point) const {
    const Vec<3> from = point - center_;
    const Vec<3> radial = from - from.dot(axis_) * axis_;
    const double distance = radial.norm();
    // On the axis all of the circle is as near: any direction across it.
    const Vec<3> outwards = distance > 0 ? Vec<3>(radial / distance) : axis_.unitOrthogonal();
    return from - ring_radius_ * outwards;
}

double Torus::signedDistance(const Vec<3>& point) const { return fromCore(point).norm() - radius_; }

Vec<3> Torus::normal(const Vec<3>& point) const {
    const Vec<3> from = fromCore(point);
    const double distance = from.norm();
    return distance > 0 ? Vec<3>(from / distance) : axis_;
}

Box<3> Torus::bounds() const {
    // Of the circle, and a ball about each of its points.
    const Vec<3> reach =
        (ring_radius_ * (1 - axis_.array().square()).max(0).sqrt() + radius_).matrix();
    return {center_ - reach, center_ + reach};
}

ShapePointer<3> Torus::transformed(const Similarity<3>& map) const {
    return std::make_shared<Torus>(map(center_), Vec<3>(map.turn() * axis_),
                                   map.factor * ring_radius_, map.factor * radius_);
}

ShapePointer<3> Torus::grown(double by) const {
    const double radius = radius_ + by;
    if (radius <= 0) return nullptr;
    if (radius >= ring_radius_)
        throw ShapeError(
            fmt::format("the offset {} closes the hole of a torus whose ring_radius "
                        "is {} and radius {}",
                        by, ring_radius_, radius_));
    return std::make_shared<Torus>(center_, axis_, ring_radius_, radius);
}

}  // namespace sphinx::geometry
