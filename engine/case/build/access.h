// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "case/model/model.h"
#include "dynamics/dynamics.h"

#include <string_view>
#include <vector>

namespace sphinx::model {

/// Fields that an action of a method reads, writes and accumulates, with the names of the case's
/// bodies in place of parameters and `neighbors`. For a time-step method: those of its estimate.
std::vector<FieldAccess> resolveAccesses(const Case& model, const Component& method, int action);

/// Whether a method that the loop calls reads, writes or accumulates that field of the body.
bool isAccessed(const Case& model, const Body& body, std::string_view field);

}  // namespace sphinx::model
