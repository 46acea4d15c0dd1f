// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/world.h"
#include "case/model/model.h"
#include "input/tree/diagnostics.h"

#include <memory>

namespace sphinx::build {

/// Bodies with their particles and initial values. What only shows on particles goes to
/// `diagnostics`: a body without particles, bodies that overlap, fluid outside of the domain.
/// Without `particles` the bodies stay empty, for a restart to fill.
template <int Dim>
std::unique_ptr<bodies::World<Dim>> buildWorld(const model::Case& model, bool particles,
                                               input::Diagnostics& diagnostics);

}  // namespace sphinx::build
