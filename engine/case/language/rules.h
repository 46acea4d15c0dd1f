// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "dynamics/declare.h"
#include "input/tree/diagnostics.h"

namespace sphinx::language {

/// The rules of a declaration of Kind::dynamics; nullptr for a time step, which has none.
const dynamics::MethodBuilder* rulesOf(const input::Declaration& declaration);

/// The case as rules see it. It refers to both.
dynamics::WrittenCase writtenCase(const model::Case& model, input::Diagnostics& diagnostics);

/// Rules stand beside the methods, in their declarations: asks those about the case as it is
/// written (DeclaredMethod::rule).
void checkRules(const model::Case& model, input::Diagnostics& diagnostics);

}  // namespace sphinx::language
