// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/declare.h"

#include <array>
#include <cstdint>

namespace sphinx::dynamics::geometry {

struct NormalsFromShapeParameters {
    input::Name body;
    std::vector<input::Name> joined;
};

/// Normal and depth of every particle from the signed distance of the body's shape: the normal of
/// the nearest point of its surface, outwards, and the distance to it. Bodies bonded to it, and
/// those joined to it, belong to the shape: where two parts meet is no surface.
///
/// Where the nearest point is none of the surface of the whole, or another face is as near (the
/// particles of an edge), the normal is that of the smoothed whole,
///   n = -sum_s c(x + s) W(s) s / |...|,   c = 1 inside of a part, 0 outside,
/// over points s half a spacing apart: at an edge the mean of both faces. (With the normal of one
/// of them fluid that moves along that face is not held back by the particle, and enters the
/// solid.)
template <int Dim>
class NormalsFromShape final : public Method {
 public:
    NormalsFromShape(Body<Dim>& body, const std::vector<Body<Dim>*>& joined);

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    /// A point of the sum that smooths, with its weight in whole numbers: so the sum of a mirrored
    /// or turned solid is the mirrored or turned sum.
    struct StencilPoint {
        Vec<Dim> offset;
        std::array<int, Dim> place;  // in steps
        std::int64_t weight;
    };
    void makeStencil();
    bool insideOther(const Vec<Dim>& x) const;
    /// Of the whole.
    bool inside(const Vec<Dim>& x) const;
    /// Another face, at an angle, is the nearest within half a spacing.
    bool nearEdge(const Vec<Dim>& x) const;
    /// Zero where the surface of the whole is out of reach.
    Vec<Dim> smoothedNormal(const Vec<Dim>& x) const;
    double depthAlong(const Vec<Dim>& x, const Vec<Dim>& normal) const;

    Body<Dim>* body_;
    sphinx::geometry::ShapePointer<Dim> shape_;
    std::vector<sphinx::geometry::ShapePointer<Dim>> others_;
    std::vector<StencilPoint> stencil_;
    Field<Vec<Dim>>& normal_;
    Field<Vec<Dim>>& initial_normal_;
    Field<double>& depth_;
};

/// Registers geometry.normals_from_shape.
void declareNormalsFromShape(input::Registry& registry);

}  // namespace sphinx::dynamics::geometry
