// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

namespace sphinx::check {

/// Elastic bodies, with those bonded to them, do not reach across a periodic side of the domain:
/// their particles would be neighbors of those at the other end, a whole domain away.
template <int Dim>
void checkElastic(const model::Case& model, const bodies::World<Dim>& world,
                  input::Diagnostics& diagnostics);

}  // namespace sphinx::check
