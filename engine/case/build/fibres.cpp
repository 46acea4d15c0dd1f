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
void checkFibres(const Component& material, const std::vector<Vec<Dim>>& places,
                 input::Diagnostics& diagnostics) {
    const auto& parameters = material.as<HolzapfelMuscleParameters>();
    for (const Vec<Dim>& place : places) {
        Fibres<Dim> fibres;
        if (const auto violation = parameters.directions<Dim>(place, fibres)) {
            diagnostics.error(material.placeOf(violation->parameter), violation->message);
            return;
        }
    }
}

template void checkFibres(const Component&, const std::vector<Vec<2>>&, input::Diagnostics&);
template void checkFibres(const Component&, const std::vector<Vec<3>>&, input::Diagnostics&);

}  // namespace sphinx::model
