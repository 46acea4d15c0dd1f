// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rings.h"
#include "geometry/shape.h"
#include "geometry/similarity.h"

namespace sphinx::geometry {

/// What every shape of this folder can do besides answering questions. No wrapper shapes: a
/// transform or offset goes down to the primitives, which know how to do it exactly.
template <int Dim>
class Composable : public Shape<Dim> {
 public:
    virtual ShapePointer<Dim> transformed(const Similarity<Dim>& map) const = 0;
    /// Null when nothing remains.
    virtual ShapePointer<Dim> grown(double by) const = 0;
};

/// A shape of the plane that can give its boundary as polygons.
class Region : public Composable<2> {
 public:
    virtual Rings rings() const = 0;
};

template <int Dim>
const Composable<Dim>& composable(const ShapePointer<Dim>& shape) {
    return dynamic_cast<const Composable<Dim>&>(*shape);
}

}  // namespace sphinx::geometry
