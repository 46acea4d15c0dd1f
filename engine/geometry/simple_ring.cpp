// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/box_tree.h"
#include "geometry/orientation.h"
#include "geometry/rings.h"
#include "geometry/shape.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace sphinx::geometry {
namespace {

struct Edge {
    Vec<2> a, b;
    Box<2> box() const { return {a.cwiseMin(b), a.cwiseMax(b)}; }
};

std::string text(const Vec<2>& p) { return fmt::format("({}, {})", p.x(), p.y()); }

std::string text(std::size_t number, const Edge& edge) {
    return fmt::format("edge {} from {} to {}", number + 1, text(edge.a), text(edge.b));
}

std::vector<Edge> edgesOf(const Ring& ring) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
    return edges;
}

BoxTree treeOf(const std::vector<Edge>& edges) {
    std::vector<Box<2>> boxes;
    for (const Edge& edge : edges) boxes.push_back(edge.box());
    return BoxTree(boxes);
}

/// Number of common points: 0, 1 (as `crossing` when both pass through it), or many.
struct Meeting {
    bool any = false, crossing = false, overlap = false;
};

Meeting meet(const Edge& e, const Edge& f) {
    const int fa = orientation(e.a, e.b, f.a), fb = orientation(e.a, e.b, f.b);
    const int ea = orientation(f.a, f.b, e.a), eb = orientation(f.a, f.b, e.b);
    Meeting result;
    if (fa == 0 && fb == 0) {
        const Box<2> x = e.box(), y = f.box();
        const Vec<2> lower = x.lower.cwiseMax(y.lower), upper = x.upper.cwiseMin(y.upper);
        result.any = (lower.array() <= upper.array()).all();
        result.overlap = result.any && lower != upper;
    } else {
        result.any = fa * fb <= 0 && ea * eb <= 0;
        result.crossing = fa * fb < 0 && ea * eb < 0;
    }
    return result;
}

void checkPoints(const Ring& ring, const std::string& name) {
    if (ring.size() < 3) {
        throw ShapeError(
            fmt::format("{}a polygon needs at least 3 points, this one has {}", name, ring.size()));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (!ring[i].allFinite()) {
            throw ShapeError(fmt::format("{}point {} is {}; coordinates must be finite numbers",
                                         name, i + 1, text(ring[i])));
        }
    }
    if (ring.front() == ring.back()) {
        throw ShapeError(
            fmt::format("{}the last point {} repeats the first; a polygon closes by itself", name,
                        text(ring.back())));
    }
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        if (ring[i] == ring[i + 1]) {
            throw ShapeError(
                fmt::format("{}points {} and {} are equal: {}", name, i + 1, i + 2, text(ring[i])));
        }
    }
    const bool line = std::all_of(ring.begin() + 2, ring.end(), [&](const Vec<2>& p) {
        return orientation(ring[0], ring[1], p) == 0;
    });
    if (line) throw ShapeError(fmt::format("{}all points lie on one line", name));
}

void checkSimple(const Ring& ring, const std::string& name) {
    const std::vector<Edge> edges = edgesOf(ring);
    const std::size_t n = edges.size();
    const BoxTree tree = treeOf(edges);
    for (std::size_t i = 0; i < n; ++i) {
        // The first partner by number, so that the message does not depend on the tree.
        std::size_t partner = n;
        Meeting worst;
        tree.forOverlapping(edges[i].box(), [&](std::size_t j) {
            if (j <= i || j >= partner) return;
            const Meeting meeting = meet(edges[i], edges[j]);
            const bool neighbors = j == i + 1 || (i == 0 && j == n - 1);
            if (neighbors ? !meeting.overlap : !meeting.any) return;
            partner = j;
            worst = meeting;
        });
        if (partner == n) continue;
        const char* how = worst.overlap ? "runs along" : worst.crossing ? "crosses" : "touches";
        throw ShapeError(
            fmt::format("{}{} {} {}; edges may meet only where one ends and the next begins", name,
                        text(i, edges[i]), how, text(partner, edges[partner])));
    }
}

}  // namespace

Ring simpleRing(Ring ring, const std::string& name) {
    checkPoints(ring, name);
    checkSimple(ring, name);
    if (signedArea(ring) < 0) std::reverse(ring.begin(), ring.end());
    return ring;
}

void checkHole(const Ring& outer, const Ring& hole, const std::string& name) {
    const std::vector<Edge> outer_edges = edgesOf(outer), hole_edges = edgesOf(hole);
    const BoxTree tree = treeOf(outer_edges);
    for (std::size_t i = 0; i < hole_edges.size(); ++i) {
        tree.forOverlapping(hole_edges[i].box(), [&](std::size_t j) {
            const Meeting meeting = meet(hole_edges[i], outer_edges[j]);
            if (!meeting.crossing) return;
            throw ShapeError(
                fmt::format("{}{} crosses {} of the outer ring; a hole must lie inside", name,
                            text(i, hole_edges[i]), text(j, outer_edges[j])));
        });
    }
    const ShapePointer<2> inside = makePolygon(outer);
    for (std::size_t i = 0; i < hole.size(); ++i) {
        if (!inside->contains(hole[i])) {
            throw ShapeError(fmt::format("{}point {} at {} lies outside the outer ring", name,
                                         i + 1, text(hole[i])));
        }
    }
}

}  // namespace sphinx::geometry
