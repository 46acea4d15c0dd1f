// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/world_rules.h"

#include "case/language/rules.h"

namespace sphinx::model {

template <int Dim>
void checkWorldRules(const Case& model, const World<Dim>& world, input::Diagnostics& diagnostics) {
    BuiltCase<Dim> built{writtenCase(model, diagnostics), world};
    for (const Component& method : model.dynamics)
        if (const MethodBuilder* of = rulesOf(*method.declaration))
            for (const WorldRule& rule : of->world_rules) rule.check(method, built);
    for (const std::string& name : model.registry->names(input::Kind::dynamics))
        if (const MethodBuilder* of = rulesOf(*model.registry->find(input::Kind::dynamics, name)))
            for (const CaseRule& rule : of->case_rules) rule.check(built);
}

template void checkWorldRules(const Case&, const World<2>&, input::Diagnostics&);
template void checkWorldRules(const Case&, const World<3>&, input::Diagnostics&);

}  // namespace sphinx::model
