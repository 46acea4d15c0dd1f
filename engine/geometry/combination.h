// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/composable.h"
#include "geometry/overlay.h"

#include <vector>

namespace sphinx::geometry {

/// Boolean of solids by their signed distances: the smallest for a union, the largest for an
/// intersection, subtracted shapes with the opposite sign. The part that decides gives the normal.
class Combination final : public Composable<3> {
 public:
    /// At least one part.
    Combination(Rule rule, std::vector<ShapePointer<3>> parts);

    bool contains(const Vec<3>& point) const override { return signedDistance(point) <= 0; }
    double signedDistance(const Vec<3>& point) const override { return decide(point).distance; }
    Vec<3> normal(const Vec<3>& point) const override;
    Box<3> bounds() const override { return bounds_; }
    bool empty() const override { return bounds_.empty(); }
    ShapePointer<3> transformed(const Similarity<3>& map) const override;
    ShapePointer<3> grown(double by) const override;

 private:
    struct Decision {
        std::size_t part;
        double distance;
    };
    Decision decide(const Vec<3>& point) const;
    double sign(std::size_t part) const {
        return rule_ == Rule::first_not_rest && part > 0 ? -1 : 1;
    }

    Rule rule_;
    std::vector<ShapePointer<3>> parts_;
    Box<3> bounds_;
};

}  // namespace sphinx::geometry
