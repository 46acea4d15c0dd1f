// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::measure {

/// Declares the outputs that measure: observers and reductions.
void registerMeasures(input::Registry& registry);

}  // namespace sphinx::measure
