// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"

#include <array>

namespace sphinx::fitting {

/// Surfaces that lie somewhat below that of a shape, and how points get onto them.
template <int Dim>
class SurfaceRow {
 public:
    SurfaceRow(const geometry::Shape<Dim>& shape, double spacing)
        : shape_(&shape), spacing_(spacing) {}

    /// The place nearest to x that is so deep: on one plane parallel to the nearest face, or where
    /// those of up to Dim faces meet. Where the shape is not thick enough it lies between its
    /// faces, less deep.
    Vec<Dim> place(const Vec<Dim>& x, double depth) const;

 private:
    /// Points y with n . y = c.
    struct Plane {
        Vec<Dim> n;
        double c;
    };
    struct Planes {
        std::array<Plane, Dim> plane;
        int count = 0;

        void add(const Plane& one);
        /// The nearest point to x on all of them.
        Vec<Dim> nearest(const Vec<Dim>& x) const;
    };

    const geometry::Shape<Dim>* shape_;
    double spacing_;
};

extern template class SurfaceRow<2>;
extern template class SurfaceRow<3>;

}  // namespace sphinx::fitting
