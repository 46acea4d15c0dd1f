// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/fibres.h"

#include "materials/holzapfel_muscle.h"

namespace sphinx::model {

bool hasFibres(const Case& model, const Body& body) {
    const Component* material = model.findMaterial(body.material.text);
    return material && material->declaration->hasTrait("fibres");
}

template <int Dim>
void setFibres(const Component& material, sphinx::Body<Dim>& body,
               input::Diagnostics& diagnostics) {
    const auto& parameters = material.as<HolzapfelMuscleParameters>();
    const auto& position = body.particles.position();
    auto& fibre = body.particles.vector(fields::fibre);
    auto& sheet = body.particles.vector(fields::sheet);
    for (std::size_t i = 0; i < body.size(); ++i) {
        Fibres<Dim> fibres;
        if (const auto violation = parameters.directions<Dim>(position[i], fibres)) {
            diagnostics.error(material.placeOf(violation->parameter), violation->message);
            return;
        }
        fibre[i] = fibres.fibre;
        sheet[i] = fibres.sheet;
    }
}

template void setFibres(const Component&, sphinx::Body<2>&, input::Diagnostics&);
template void setFibres(const Component&, sphinx::Body<3>&, input::Diagnostics&);

}  // namespace sphinx::model
