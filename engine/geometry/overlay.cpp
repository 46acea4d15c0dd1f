// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/overlay.h"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <utility>

// CGAL's polygon sets refuse rings that cross themselves, which rounding to doubles can cause; so
// this is their arrangement with winding numbers instead of their validity checks.

namespace sphinx::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;

/// By how much the winding number of an operand is higher left of the segment than right of it,
/// the segment seen from its lexicographically smaller end.
using Steps = std::vector<std::pair<std::size_t, int>>;
struct Join {
    Steps operator()(const Steps& a, const Steps& b) const {
        Steps both = a;
        both.insert(both.end(), b.begin(), b.end());
        return both;
    }
};
using Traits = CGAL::Arr_curve_data_traits_2<SegmentTraits, Steps, Join>;

struct FaceState {
    std::vector<int> winding;  ///< empty: not yet reached
    bool covered = false;
};
using Dcel = CGAL::Arr_extended_dcel<Traits, char, bool, FaceState>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Face = Arrangement::Face_handle;
using Halfedge = Arrangement::Halfedge_handle;

std::vector<Traits::X_monotone_curve_2> segmentsOf(const std::vector<Rings>& operands) {
    std::vector<Traits::X_monotone_curve_2> segments;
    for (std::size_t operand = 0; operand < operands.size(); ++operand) {
        for (const Ring& ring : operands[operand]) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec<2>&a = ring[i], &b = ring[(i + 1) % ring.size()];
                if (a == b) continue;
                const bool forward = a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
                const SegmentTraits::X_monotone_curve_2 segment(Point(a.x(), a.y()),
                                                                Point(b.x(), b.y()));
                segments.emplace_back(segment, Steps{{operand, forward ? 1 : -1}});
            }
        }
    }
    return segments;
}

bool covers(const std::vector<int>& winding, Rule rule) {
    const auto in = [](int w) { return w > 0; };
    switch (rule) {
        case Rule::any: return std::any_of(winding.begin(), winding.end(), in);
        case Rule::all: return std::all_of(winding.begin(), winding.end(), in);
        case Rule::first_not_rest:
            return in(winding.front()) && std::none_of(winding.begin() + 1, winding.end(), in);
    }
    return false;
}

/// Winding numbers from face to face, starting outside with zero.
void classify(Arrangement& arrangement, std::size_t operands, Rule rule) {
    std::vector<Face> reached{arrangement.unbounded_face()};
    reached.front()->data().winding.assign(operands, 0);
    const auto cross = [&](const Face& face, Arrangement::Ccb_halfedge_circulator begin) {
        auto edge = begin;
        do {
            const Face other = edge->twin()->face();
            if (!other->data().winding.empty()) continue;
            std::vector<int> winding = face->data().winding;
            const int direction = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? 1 : -1;
            for (const auto& [operand, step] : edge->curve().data()) {
                winding[operand] -= direction * step;
            }
            other->data().winding = std::move(winding);
            reached.push_back(other);
        } while (++edge != begin);
    };
    while (!reached.empty()) {
        const Face face = reached.back();
        reached.pop_back();
        face->data().covered = covers(face->data().winding, rule);
        for (auto c = face->outer_ccbs_begin(); c != face->outer_ccbs_end(); ++c) cross(face, *c);
        for (auto c = face->inner_ccbs_begin(); c != face->inner_ccbs_end(); ++c) cross(face, *c);
    }
}

bool onBoundary(const Halfedge& edge) {
    return edge->face()->data().covered && !edge->twin()->face()->data().covered;
}

/// Follows the boundary of the covered sector at each corner: regions that touch in a corner come
/// out apart.
std::vector<Point> trace(const Halfedge& start) {
    std::vector<Point> ring;
    Halfedge edge = start;
    do {
        edge->set_data(true);
        ring.push_back(edge->source()->point());
        edge = edge->next();
        while (!onBoundary(edge)) edge = edge->twin()->next();
    } while (edge != start);
    return ring;
}

double rounded(const Kernel::FT& value) {
    const auto& interval = value.approx();
    return interval.is_point() ? interval.inf() : CGAL::to_double(value.exact());
}

/// Corners only: points where the overlay cut a straight edge are dropped while still exact.
Ring cornersOf(const std::vector<Point>& points) {
    Ring ring;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (CGAL::collinear(points[(i + n - 1) % n], points[i], points[(i + 1) % n])) continue;
        ring.emplace_back(rounded(points[i].x()), rounded(points[i].y()));
    }
    return ring;
}

}  // namespace

Rings overlay(const std::vector<Rings>& operands, Rule rule) {
    const auto segments = segmentsOf(operands);
    Arrangement arrangement;
    CGAL::insert(arrangement, segments.begin(), segments.end());
    classify(arrangement, operands.size(), rule);
    for (auto edge = arrangement.halfedges_begin(); edge != arrangement.halfedges_end(); ++edge) {
        edge->set_data(false);
    }
    Rings rings;
    for (auto edge = arrangement.halfedges_begin(); edge != arrangement.halfedges_end(); ++edge) {
        if (!edge->data() && onBoundary(edge)) rings.push_back(cornersOf(trace(edge)));
    }
    return withoutSlivers(std::move(rings));
}

}  // namespace sphinx::geometry
