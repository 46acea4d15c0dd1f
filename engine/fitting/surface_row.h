// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shape.h"

#include <array>

namespace sphinx::fitting {

/// The surface that lies so deep below that of a shape, and how points get onto it.
template <int Dim>
class SurfaceRow {
 public:
    /// Both lengths. `depth` may change later: the row goes down.
    SurfaceRow(const geometry::Shape<Dim>& shape, double spacing)
        : shape_(&shape), spacing_(spacing) {}

    /// The nearest point to x that lies as deep as that or deeper, of an x that is less deep: on
    /// the planes of the nearest faces, of which there are up to Dim at corners. Where the shape is
    /// not as thick it is a point between its faces, less deep. x that is deeper moves up onto it.
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
