// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/geometry/normals_from_shape.h"

#include "core/parallel.h"

namespace sphinx::geometry {
namespace {

template <int Dim>
ShapePointer<Dim> wholeShape(const Body<Dim>& body) {
    if (body.bonded.empty()) return body.shape;
    std::vector<ShapePointer<Dim>> shapes{body.shape};
    for (const Body<Dim>* other : body.bonded) shapes.push_back(other->shape);
    return makeUnion<Dim>(shapes);
}

}  // namespace

template <int Dim>
NormalsFromShape<Dim>::NormalsFromShape(Body<Dim>& body)
    : body_(&body),
      shape_(wholeShape(body)),
      normal_(body.particles.vector(fields::normal)),
      initial_normal_(body.particles.vector(fields::initial_normal)),
      depth_(body.particles.scalar(fields::depth)) {}

template <int Dim>
void NormalsFromShape<Dim>::run(int, const Clock&) {
    const auto& position = body_->particles.position();
    parallelFor(body_->size(), [&](std::size_t i) {
        normal_[i] = shape_->normal(position[i]);
        initial_normal_[i] = normal_[i];
        depth_[i] = -shape_->signedDistance(position[i]);
    });
}

void declareNormalsFromShape(input::Registry& registry) {
    using P = NormalsFromShapeParameters;
    auto& d = registry.declare<P>(input::Kind::dynamics, "geometry.normals_from_shape");
    d.summary("Normals and depths of a solid's particles from the signed distance of its shape");
    d.required("body", &P::body, input::bodyReference({"solid"}), "solid body with a shape");
    d.action("", "")
        .reads("body", {"position"})
        .writes("body", {"normal", "initial_normal", "depth"});
    d.builder(factory<Method, P>([]<int Dim>(const P& p, Context<Dim>& context) {
        return std::make_unique<NormalsFromShape<Dim>>(bodyOf(context, p.body));
    }));
}

template class NormalsFromShape<2>;
template class NormalsFromShape<3>;

}  // namespace sphinx::geometry
