// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::particles {

/// Makes the fields known to list, describe and the reference page, with rank and unit.
void registerFields(input::Registry& registry);

}  // namespace sphinx::particles
