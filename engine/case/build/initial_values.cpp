// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/build/initial_values.h"

#include "case/build/access.h"
#include "core/parallel.h"
#include "input/expressions/vector_at_time.h"

#include <algorithm>

namespace sphinx::build {

template <int Dim>
void giveInitialValues(const model::Body& source, double time,
                       std::vector<bodies::NewParticle<Dim>>& particles) {
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

std::vector<std::string> initialFields(const model::Case& model, const model::Body& body) {
    const input::Component* material = model.findMaterial(body.material.text);
    const bool fibres = material && material->declaration->hasTrait("fibres");
    std::vector<const particles::FieldInfo*> own = bodies::ownFields(body.role, fibres);
    if (!body.parts.empty()) own.push_back(&fields::initial_position);
    std::vector<std::string> names;
    for (const particles::FieldInfo* field : fields::all()) {
        // What accelerates a fluid stands in the loop, if only a gravity of zero: that nothing does
        // is a line forgotten, not a field without a value.
        if (body.role == bodies::Role::fluid && field == &fields::external_acceleration) continue;
        const bool its_own = std::find(own.begin(), own.end(), field) != own.end();
        const bool given = field->initial.kind == particles::InitialValue::Kind::given;
        if (its_own || (field->hasInitialValue() && !given && isAccessed(model, body, field->name)))
            names.emplace_back(field->name);
    }
    return names;
}

template void giveInitialValues(const model::Body&, double, std::vector<bodies::NewParticle<2>>&);
template void giveInitialValues(const model::Body&, double, std::vector<bodies::NewParticle<3>>&);

}  // namespace sphinx::build
