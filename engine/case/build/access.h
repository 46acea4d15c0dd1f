// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "dynamics/dynamics.h"

#include <string_view>
#include <vector>

namespace sphinx::build {

/// Fields that an action of a method reads, writes and accumulates, with the names of the case's
/// bodies in place of parameters and `neighbors`. For a time-step method: those of its estimate.
std::vector<dynamics::FieldAccess> resolveAccesses(const model::Case& model,
                                                   const input::Component& method, int action);

/// Whether a method that the loop calls reads, writes or accumulates that field of the body.
bool isAccessed(const model::Case& model, const model::Body& body, std::string_view field);

}  // namespace sphinx::build
