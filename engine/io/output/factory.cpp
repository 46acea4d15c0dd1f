// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/output/factory.h"

#include "core/errors.h"
#include "input/tree/diagnostics.h"
#include "input/tree/suggest.h"

namespace sphinx::io {

void failAt(const input::Place& place, const std::string& message) {
    input::Diagnostics diagnostics;
    diagnostics.error(place, message);
    diagnostics.throwIfErrors();
    throw CaseError(message);
}

template <int Dim>
const particles::FieldBase& fieldOf(const bodies::Body<Dim>& body, const input::Name& field) {
    if (const particles::FieldBase* found = body.particles.find(field.text)) return *found;
    std::vector<std::string> names;
    for (const auto& one : body.particles.all()) names.emplace_back(one->info().name);
    failAt(field.place, "'" + body.name + "' has no field '" + field.text + "' in this case" +
                            input::didYouMean(field.text, names));
}

template const particles::FieldBase& fieldOf(const bodies::Body<2>&, const input::Name&);
template const particles::FieldBase& fieldOf(const bodies::Body<3>&, const input::Name&);

}  // namespace sphinx::io
