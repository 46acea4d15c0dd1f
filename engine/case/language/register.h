// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::language {

/// Every declaration of the program. The registry must not move afterwards.
void registerAll(input::Registry& registry);

}  // namespace sphinx::language
