// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/disc.h"

#include <cmath>
#include <numbers>

namespace sphinx::geometry {

bool Disc::contains(const Vec<2>& point) const { return signedDistance(point) <= 0; }

double Disc::signedDistance(const Vec<2>& point) const {
    return (point - center_).norm() - radius_;
}

Vec<2> Disc::normal(const Vec<2>& point) const {
    const Vec<2> away = point - center_;
    const double distance = away.norm();
    return distance > 0 ? Vec<2>(away / distance) : Vec<2>::UnitX();
}

Box<2> Disc::bounds() const {
    return {center_ - Vec<2>::Constant(radius_), center_ + Vec<2>::Constant(radius_)};
}

double Disc::measure() const { return std::numbers::pi * radius_ * radius_; }

Rings Disc::rings() const {
    // n corners at radius R enclose n/2 R^2 sin(2 pi/n). Set equal to pi r^2, the corners lie
    // (2 pi/n)^2/12 r = 7.8e-7 r outside the circle and the middles of edges half as much inside.
    constexpr int n = 2048;
    constexpr double part = 2 * std::numbers::pi / n;
    const double corner_radius = radius_ * std::sqrt(part / std::sin(part));
    Ring ring(n);
    // One eighth of the circle, mirrored, so that the polygon has the symmetries of its lattice.
    for (int k = 0; k <= n / 8; ++k) {
        const double x = corner_radius * std::cos(k * part);
        const double y = k == n / 8 ? x : corner_radius * std::sin(k * part);
        const auto put = [&](int corner, double dx, double dy) {
            ring[static_cast<std::size_t>((corner + n) % n)] = center_ + Vec<2>(dx, dy);
        };
        put(k, x, y), put(-k, x, -y), put(n / 2 - k, -x, y), put(n / 2 + k, -x, -y);
        put(n / 4 - k, y, x), put(n / 4 + k, -y, x), put(-n / 4 + k, y, -x),
            put(-n / 4 - k, -y, -x);
    }
    return {ring};
}

ShapePointer<2> Disc::transformed(const Similarity<2>& map) const {
    return std::make_shared<Disc>(map(center_), map.factor * radius_);
}

ShapePointer<2> Disc::grown(double by) const {
    return radius_ + by > 0 ? std::make_shared<Disc>(center_, radius_ + by) : nullptr;
}

}  // namespace sphinx::geometry
