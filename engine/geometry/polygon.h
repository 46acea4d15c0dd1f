// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/box_tree.h"
#include "geometry/composable.h"

#include <vector>

namespace sphinx::geometry {

/// Any number of polygons with holes, or none. The rings do not cross (but for rounding) and have
/// the region on their left.
class Polygon final : public Region {
 public:
    explicit Polygon(Rings rings);

    bool contains(const Vec<2>& point) const override;
    double signedDistance(const Vec<2>& point) const override;
    Vec<2> normal(const Vec<2>& point) const override;
    Box<2> bounds() const override { return bounds_; }
    bool empty() const override { return rings_.empty(); }
    double measure() const override;
    void rowContains(const Vec<2>& first, double step, std::size_t count,
                     std::uint8_t* inside) const override;

    Rings rings() const override { return rings_; }
    ShapePointer<2> transformed(const Similarity<2>& map) const override;
    ShapePointer<2> grown(double by) const override;

 private:
    struct Edge {
        Vec<2> a, b;
        Vec<2> normal;              ///< outwards
        Vec<2> normal_a, normal_b;  ///< at the corners: mean with the neighboring edge's
    };
    struct Nearest {
        std::size_t edge;
        double t;  ///< place on the edge: 0 is a, 1 is b
        double squared_distance;
    };
    Nearest nearest(const Vec<2>& point) const;

    Rings rings_;
    Box<2> bounds_;
    std::vector<Edge> edges_;
    BoxTree tree_;
};

}  // namespace sphinx::geometry
