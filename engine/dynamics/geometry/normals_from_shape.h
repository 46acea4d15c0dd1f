// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/builder.h"

namespace sphinx::geometry {

struct NormalsFromShapeParameters {
    input::Name body;
};

/// Normal and depth of every particle from the signed distance of the body's shape: the normal of
/// the nearest point of its surface, outwards, and the distance to it. Bodies bonded to it belong
/// to the shape: where two parts of one piece meet is no surface.
template <int Dim>
class NormalsFromShape final : public Method {
 public:
    explicit NormalsFromShape(Body<Dim>& body);

    void run(int action, const Clock& clock) override;
    std::size_t workSize() const override { return body_->size(); }

 private:
    Body<Dim>* body_;
    ShapePointer<Dim> shape_;
    Field<Vec<Dim>>& normal_;
    Field<Vec<Dim>>& initial_normal_;
    Field<double>& depth_;
};

/// Registers geometry.normals_from_shape.
void declareNormalsFromShape(input::Registry& registry);

extern template class NormalsFromShape<2>;
extern template class NormalsFromShape<3>;

}  // namespace sphinx::geometry
