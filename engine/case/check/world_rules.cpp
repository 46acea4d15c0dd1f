// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/check/checks.h"
#include "core/errors.h"

#include "case/language/rules.h"

namespace sphinx::check {

template <int Dim>
void checkWorldRules(const model::Case& model, const bodies::World<Dim>& world,
                     input::Diagnostics& diagnostics) {
    dynamics::BuiltCase<Dim> built{language::writtenCase(model, diagnostics), world};
    for (const input::Component& method : model.dynamics)
        if (const dynamics::MethodBuilder* of = language::rulesOf(*method.declaration))
            for (const dynamics::WorldRule& rule : of->world_rules) try {
                    rule.check(method, built);
                } catch (const PhysicsError& e) {  // of an expression at the start
                    diagnostics.error(method.place, e.what());
                }
    for (const std::string& name : model.registry->names(input::Kind::dynamics))
        if (const dynamics::MethodBuilder* of =
                language::rulesOf(*model.registry->find(input::Kind::dynamics, name)))
            for (const dynamics::CaseRule& rule : of->case_rules) rule.check(built);
}

template void checkWorldRules(const model::Case&, const bodies::World<2>&, input::Diagnostics&);
template void checkWorldRules(const model::Case&, const bodies::World<3>&, input::Diagnostics&);

}  // namespace sphinx::check
