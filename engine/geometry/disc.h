// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/composable.h"

namespace sphinx::geometry {

/// A circle, exact: smooth normals as long as no boolean makes a polygon of it.
class Disc final : public Region {
 public:
    Disc(const Vec<2>& center, double radius) : center_(center), radius_(radius) {}

    bool contains(const Vec<2>& point) const override;
    double signedDistance(const Vec<2>& point) const override;
    Vec<2> normal(const Vec<2>& point) const override;
    Box<2> bounds() const override;
    bool empty() const override { return false; }
    double measure() const override;

    Rings rings() const override;
    ShapePointer<2> transformed(const Similarity<2>& map) const override;
    ShapePointer<2> grown(double by) const override;

 private:
    Vec<2> center_;
    double radius_;
};

}  // namespace sphinx::geometry
