// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/initial_values.h"

#include "case/build/access.h"
#include "core/parallel.h"
#include "input/expressions/vector_at_time.h"

#include <algorithm>

namespace sphinx::model {

template <int Dim>
void giveInitialValues(const Body& source, double time, std::vector<NewParticle<Dim>>& particles) {
    if (source.initial.velocity) {
        const input::VectorAtTime<Dim> initial(*source.initial.velocity, time);
        parallelFor(particles.size(),
                    [&](std::size_t i) { particles[i].velocity = initial(particles[i].position); });
    }
    if (source.initial.pressure)
        parallelFor(particles.size(), [&](std::size_t i) {
            particles[i].pressure =
                source.initial.pressure->template operator()<Dim>(particles[i].position, time);
        });
}

std::vector<std::string> initialFields(const Case& model, const Body& body) {
    const Component* material = model.findMaterial(body.material.text);
    const bool fibres = material && material->declaration->hasTrait("fibres");
    std::vector<const FieldInfo*> own = ownFields(body.role, fibres);
    if (!body.parts.empty()) own.push_back(&fields::initial_position);
    std::vector<std::string> names;
    for (const FieldInfo* field : fields::all()) {
        // What accelerates a fluid stands in the loop, if only a gravity of zero: that nothing does
        // is a line forgotten, not a field without a value.
        if (body.role == Role::fluid && field == &fields::external_acceleration) continue;
        const bool its_own = std::find(own.begin(), own.end(), field) != own.end();
        const bool given = field->initial.kind == InitialValue::Kind::given;
        if (its_own || (field->hasInitialValue() && !given && isAccessed(model, body, field->name)))
            names.emplace_back(field->name);
    }
    return names;
}

template void giveInitialValues(const Body&, double, std::vector<NewParticle<2>>&);
template void giveInitialValues(const Body&, double, std::vector<NewParticle<3>>&);

}  // namespace sphinx::model
