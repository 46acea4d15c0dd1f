// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::io {

/// Declares the outputs that measure: observers and reductions.
void registerMeasures(input::Registry& registry);

}  // namespace sphinx::io
