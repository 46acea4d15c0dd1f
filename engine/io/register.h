// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::io {

/// Declares every output that writes the state (those that measure: measure/register.h). Their
/// builders are OutputFactory, but `restart` has none: it needs the whole simulation and is built
/// by case/ from these parameters.
void registerOutputs(input::Registry& registry);

}  // namespace sphinx::io
