// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "dynamics/turned_normal.h"

namespace sphinx::dynamics::solid {

/// Normals that turn with an elastic body: n = F^-T N / abs(F^-T N) (Nanson's formula), N at the
/// start.
void declareUpdateNormals(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareBodyMethod<P>(
        registry, "solid.update_normals", []<int Dim>(const P&, Body<Dim>& body, Context<Dim>&) {
            auto& normal = body.particles.vector(fields::normal);
            const auto& initial_normal = body.particles.vector(fields::initial_normal);
            const auto& gradient = body.particles.matrix(fields::deformation_gradient);
            return [&](const Clock&) {
                parallelFor(body.size(), [&](std::size_t i) {
                    normal[i] = turnedNormal<Dim>(gradient[i], initial_normal[i], normal[i]);
                });
            };
        });
    d.summary("Normals of an elastic body turn with its deformation");
    d.formula("n = F^-T N / abs(F^-T N)");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.action()
        .reads("body", {"initial_normal", "deformation_gradient", "normal"})
        .writes("body", {"normal"});
}

}  // namespace sphinx::dynamics::solid
