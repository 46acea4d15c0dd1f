// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "loop/flow/facts.h"

#include <vector>

namespace sphinx::build {

/// What each type of method computes from scratch: fields of its own body that an action of it
/// writes and does not read. For advice where a case lacks one.
std::vector<loop::FieldMaker> fieldMakers(const input::Registry& registry);

}  // namespace sphinx::build
