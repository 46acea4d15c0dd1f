// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/parts.h"

#include "case/build/access.h"

namespace sphinx::model {

bool keepsInitialPosition(const Case& model, const Body& body) {
    return body.role == Role::elastic || !body.parts.empty() ||
           isAccessed(model, body, fields::initial_position.name);
}

template <int Dim>
void fillParts(const Case& model, World<Dim>& world) {
    for (const Body& source : model.bodies) {
        sphinx::Body<Dim>& body = *world.find(source.name);
        for (std::size_t k = 0; k < source.parts.size(); ++k) {
            const auto& shape = model.findShape(source.parts[k].shape.text)->as<Dim>();
            const auto& start = body.particles.vector(fields::initial_position);
            body.parts[k].shape = shape;
            auto& particles = body.parts[k].particles;
            particles.clear();
            for (std::size_t i = 0; i < body.size(); ++i)
                if (shape->contains(start[i])) particles.push_back(static_cast<Index>(i));
        }
    }
}

template void fillParts(const Case&, World<2>&);
template void fillParts(const Case&, World<3>&);

}  // namespace sphinx::model
