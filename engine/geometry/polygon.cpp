// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon.h"

#include "geometry/offset.h"
#include "geometry/orientation.h"

#include <algorithm>
#include <cmath>

namespace sphinx::geometry {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a point lies for the ray that runs from it to the left. An edge is open at its upper end,
/// so that a ray through a corner counts one of two edges that pass it, and both or none of two
/// that turn there.
enum class Side { left, on, right, right_not_counted };

/// `p` at the height of the closed edge.
Side sideOf(const Vec<2>& a, const Vec<2>& b, const Vec<2>& p) {
    if (a.y() == b.y()) {
        if (p.x() < std::min(a.x(), b.x())) return Side::left;
        return p.x() > std::max(a.x(), b.x()) ? Side::right_not_counted : Side::on;
    }
    const bool up = a.y() < b.y();
    const int side = up ? orientation(a, b, p) : orientation(b, a, p);
    if (side > 0) return Side::left;
    if (side == 0) return Side::on;
    return p.y() < std::max(a.y(), b.y()) ? Side::right : Side::right_not_counted;
}

/// First k of [0, count) for which `holds`, or count; it holds for all that follow.
template <class Predicate>
std::size_t firstWhere(std::size_t count, Predicate&& holds) {
    std::size_t low = 0, high = count;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (holds(middle)) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

}  // namespace

Polygon::Polygon(Rings rings) : rings_(std::move(rings)), bounds_(boundsOf(rings_)) {
    std::vector<Box<2>> boxes;
    for (const Ring& ring : rings_) {
        const std::size_t begin = edges_.size(), n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec<2>&a = ring[i], &b = ring[(i + 1) % n];
            const Vec<2> along = b - a;
            const Vec<2> normal = Vec<2>(along.y(), -along.x()) / along.norm();
            edges_.push_back({a, b, normal, normal, normal});
            boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
        }
        for (std::size_t i = 0; i < n; ++i) {
            Edge &edge = edges_[begin + i], &next = edges_[begin + (i + 1) % n];
            const Vec<2> sum = edge.normal + next.normal;
            edge.normal_b = next.normal_a = sum.norm() > 1e-12 ? sum.normalized() : edge.normal;
        }
    }
    tree_ = BoxTree(boxes);
}

bool Polygon::contains(const Vec<2>& point) const {
    bool inside = false, on = false;
    const Box<2> ray{Vec<2>(-infinity, point.y()), point};
    tree_.forOverlapping(ray, [&](std::size_t e) {
        const Edge& edge = edges_[e];
        const double low = std::min(edge.a.y(), edge.b.y()),
                     high = std::max(edge.a.y(), edge.b.y());
        if (point.y() < low || point.y() > high) return;
        const Side side = sideOf(edge.a, edge.b, point);
        on |= side == Side::on;
        inside ^= side == Side::right;
    });
    return on || inside;
}

void Polygon::rowContains(const Vec<2>& first, double step, std::size_t count,
                          std::uint8_t* inside) const {
    if (count == 0) return;
    if (!(step > 0)) return Shape<2>::rowContains(first, step, count, inside);
    const auto at = [&](std::size_t k) {
        return Vec<2>(rowAbscissa(first.x(), step, k), first.y());
    };
    std::fill_n(inside, count, std::uint8_t{0});
    // Every edge asks the same exact question as contains(), by bisection; bit 0 marks where the
    // row enters or leaves, bit 1 the points on an edge.
    const Box<2> row{Vec<2>(-infinity, first.y()), at(count - 1)};
    tree_.forOverlapping(row, [&](std::size_t e) {
        const Edge& edge = edges_[e];
        const double low = std::min(edge.a.y(), edge.b.y()),
                     high = std::max(edge.a.y(), edge.b.y());
        if (first.y() < low || first.y() > high) return;
        const std::size_t on = firstWhere(
            count, [&](std::size_t k) { return sideOf(edge.a, edge.b, at(k)) != Side::left; });
        const std::size_t right = on + firstWhere(count - on, [&](std::size_t k) {
                                      return sideOf(edge.a, edge.b, at(on + k)) != Side::on;
                                  });
        for (std::size_t k = on; k < right; ++k) inside[k] |= 2;
        if (right < count && sideOf(edge.a, edge.b, at(right)) == Side::right) inside[right] ^= 1;
    });
    std::uint8_t in = 0;
    for (std::size_t k = 0; k < count; ++k) {
        in ^= inside[k] & 1;
        inside[k] = in | (inside[k] >> 1);
    }
}

Polygon::Nearest Polygon::nearest(const Vec<2>& point) const {
    Nearest best{edges_.size(), 0, infinity};
    tree_.nearest(point, [&](std::size_t e) {
        const Edge& edge = edges_[e];
        const Vec<2> along = edge.b - edge.a, from = point - edge.a;
        const double t = from.dot(along) / along.squaredNorm();
        // Distances to the line and to corners, not to a rounded foot: exact near the boundary.
        double squared = 0;
        if (t <= 0) {
            squared = from.squaredNorm();
        } else if (t >= 1) {
            squared = (point - edge.b).squaredNorm();
        } else {
            squared = std::pow(from.dot(edge.normal), 2);
        }
        if (squared < best.squared_distance) best = {e, t, squared};
        return best.squared_distance;
    });
    return best;
}

double Polygon::signedDistance(const Vec<2>& point) const {
    const double distance = std::sqrt(nearest(point).squared_distance);
    if (contains(point)) return 0 - distance;
    // A point just outside whose distance rounds to zero stays outside.
    return std::max(distance, std::numeric_limits<double>::min());
}

Vec<2> Polygon::normal(const Vec<2>& point) const {
    if (empty()) return Vec<2>::Zero();
    const Nearest found = nearest(point);
    const Edge& edge = edges_[found.edge];
    if (found.t > 0 && found.t < 1) return edge.normal;
    const Vec<2> away = point - (found.t <= 0 ? edge.a : edge.b);
    const double distance = away.norm();
    if (!(distance > 0)) return found.t <= 0 ? edge.normal_a : edge.normal_b;
    return (contains(point) ? -1 : 1) * away / distance;
}

double Polygon::measure() const {
    double area = 0;
    for (const Ring& ring : rings_) area += signedArea(ring);
    return area;
}

ShapePointer<2> Polygon::transformed(const Similarity<2>& map) const {
    Rings rings = rings_;
    const bool mirrors = cross(map.linear.col(0), map.linear.col(1)) < 0;
    for (Ring& ring : rings) {
        for (Vec<2>& p : ring) p = map(p);
        if (mirrors) std::reverse(ring.begin(), ring.end());
    }
    return std::make_shared<Polygon>(std::move(rings));
}

ShapePointer<2> Polygon::grown(double by) const {
    Rings rings = offsetRings(rings_, by);
    return rings.empty() ? nullptr : std::make_shared<Polygon>(std::move(rings));
}

}  // namespace sphinx::geometry
