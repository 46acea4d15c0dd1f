// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

namespace sphinx::measure {

/// Registers multibody.
void declareMultibody(input::Registry& registry);

}  // namespace sphinx::measure
