// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "geometry/offset.h"

#include "geometry/overlay.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sphinx::geometry {
namespace {

/// Mitres reach at most this many offsets from their corner.
constexpr double mitre_limit = 10;

/// A corner with the outward normals of the edges before and after it.
struct Corner {
    Vec<2> point, before, after;
    /// Sharp side outwards in the direction of the offset: the moved edges part and leave a gap.
    bool opens(double by) const { return cross(before, after) * by > 0; }
    /// Where the moved edges meet. Exact for axis-aligned edges: their normals add to +-1.
    Vec<2> mitre(double by) const {
        return point + by / (1 + before.dot(after)) * (before + after);
    }
    /// The moved corner: one point, or two where the mitre would be too long.
    Ring moved(double by) const {
        // The mitre reaches |by| / cos(turn/2), and 1 + n.n' = 2 cos^2(turn/2).
        const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + before.dot(after))));
        if (!opens(by) || cosine * mitre_limit >= 1) return {mitre(by)};
        // Cut square to the bisector at the limit: go on along each edge until there.
        const double sine = std::sqrt(1 - cosine * cosine);
        const double ahead = (mitre_limit - cosine) / sine * std::abs(by);
        const Vec<2> along_before(-before.y(), before.x()), along_after(-after.y(), after.x());
        return {point + by * before + ahead * along_before,
                point + by * after - ahead * along_after};
    }
};

std::vector<Corner> cornersOf(const Ring& ring) {
    const std::size_t n = ring.size();
    std::vector<Corner> corners(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const Vec<2> along = ring[next] - ring[i];
        const Vec<2> normal = Vec<2>(along.y(), -along.x()) / along.norm();
        corners[i].point = ring[i];
        corners[i].after = corners[next].before = normal;
    }
    return corners;
}

/// The ring with every corner moved, unless an edge would vanish or turn around.
std::optional<Ring> movedRing(const std::vector<Corner>& corners, double by) {
    const std::size_t n = corners.size();
    std::vector<Ring> moved;
    for (const Corner& corner : corners) moved.push_back(corner.moved(by));
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const Vec<2> edge = corners[next].point - corners[i].point;
        const Vec<2> moved_edge = moved[next].front() - moved[i].back();
        if (!(moved_edge.dot(edge) > 1e-12 * edge.squaredNorm())) return std::nullopt;
        ring.insert(ring.end(), moved[i].begin(), moved[i].end());
    }
    return ring;
}

/// Convex ring that closes in: what the half planes of all moved edges leave of it (perhaps
/// nothing). `by` < 0 for an outer ring, > 0 for a hole.
Ring closedIn(const std::vector<Corner>& corners, double by) {
    Ring ring;
    for (const Corner& corner : corners) ring.push_back(corner.point);
    const double side = by > 0 ? 1 : -1;
    for (const Corner& corner : corners) {
        const auto depth = [&](const Vec<2>& p) {
            return side * ((p - corner.point).dot(corner.after) - by);
        };
        Ring kept;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec<2>&p = ring[i], &q = ring[(i + 1) % ring.size()];
            const double dp = depth(p), dq = depth(q);
            if (dp >= 0) kept.push_back(p);
            if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0))
                kept.push_back(p + dp / (dp - dq) * (q - p));
        }
        ring = std::move(kept);
    }
    return ring;
}

/// The strips that the edges sweep over and the mitres between them, each wound positively.
void addSweep(const std::vector<Corner>& corners, double by, Rings& sweep) {
    const std::size_t n = corners.size();
    const auto add = [&](Ring piece) {
        if (signedArea(piece) < 0) std::reverse(piece.begin(), piece.end());
        sweep.push_back(std::move(piece));
    };
    for (std::size_t i = 0; i < n; ++i) {
        const Corner &corner = corners[i], &next = corners[(i + 1) % n];
        const Vec<2> start = corner.point + by * corner.after, end = next.point + by * corner.after;
        add({corner.point, next.point, end, start});
        if (!corner.opens(by)) continue;
        Ring mitre{corner.point, corner.point + by * corner.before};
        for (const Vec<2>& p : corner.moved(by)) mitre.push_back(p);
        mitre.push_back(start);
        add(std::move(mitre));
    }
}

}  // namespace

Rings offsetRings(const Rings& rings, double by) {
    if (by == 0) return rings;
    // Ring by ring while that is right: edges that keep their direction bound the wanted region,
    // however the rings now overlap (what turned inside out winds negatively and drops out).
    Rings moved;
    bool simple = true;
    for (const Ring& ring : rings) {
        const std::vector<Corner> corners = cornersOf(ring);
        if (std::optional<Ring> result = movedRing(corners, by)) {
            moved.push_back(std::move(*result));
        } else if (std::none_of(corners.begin(), corners.end(),
                                [&](const Corner& corner) { return corner.opens(by); })) {
            moved.push_back(closedIn(corners, by));
        } else {
            simple = false;
            break;
        }
    }
    if (simple) return overlay({moved}, Rule::any);
    // In general add, or take away, all that the edges sweep over on their way.
    Rings sweep;
    for (const Ring& ring : rings) addSweep(cornersOf(ring), by, sweep);
    return overlay({rings, sweep}, by > 0 ? Rule::any : Rule::first_not_rest);
}

}  // namespace sphinx::geometry
