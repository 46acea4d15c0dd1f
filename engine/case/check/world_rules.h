// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::check {

/// Asks the rules that want the particles at the start (DeclaredMethod::worldRule, caseRule).
template <int Dim>
void checkWorldRules(const model::Case& model, const bodies::World<Dim>& world,
                     input::Diagnostics& diagnostics);

}  // namespace sphinx::check
