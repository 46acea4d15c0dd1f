// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::dynamics {

/// Declares every method. By explicit calls: a static library may drop static initialisers.
void registerDynamics(input::Registry& registry);

}  // namespace sphinx::dynamics
