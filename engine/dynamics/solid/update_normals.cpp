// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/update_normals.h"

#include "core/parallel.h"
#include "dynamics/turned_normal.h"

namespace sphinx::dynamics::solid {

template <int Dim>
UpdateNormals<Dim>::UpdateNormals(Body<Dim>& body)
    : body_(&body),
      normal_(body.particles.vector(fields::normal)),
      initial_normal_(body.particles.vector(fields::initial_normal)),
      gradient_(body.particles.matrix(fields::deformation_gradient)) {}

template <int Dim>
void UpdateNormals<Dim>::run(const Clock&) {
    parallelFor(body_->size(), [&](std::size_t i) {
        normal_[i] = turnedNormal<Dim>(gradient_[i], initial_normal_[i], normal_[i]);
    });
}

void declareUpdateNormals(input::Registry& registry) {
    using P = UpdateNormalsParameters;
    auto& d = declareMethod<P>(
        registry, "solid.update_normals", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<UpdateNormals<Dim>>(bodyOf(context, p.body));
        });
    d.summary("Normals of an elastic body turn with its deformation");
    d.formula("n = F^-T N / abs(F^-T N)");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.action()
        .reads("body", {"initial_normal", "deformation_gradient", "normal"})
        .writes("body", {"normal"});
}

template class UpdateNormals<2>;
template class UpdateNormals<3>;

}  // namespace sphinx::dynamics::solid
