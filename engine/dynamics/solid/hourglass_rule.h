// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/rules.h"

namespace sphinx::dynamics::solid {

/// A rule of methods that step an elastic body: a body has one hourglass control, by whichever of
/// them it is stepped.
void checkHourglassControl(const input::Component& method, WrittenCase& written);

}  // namespace sphinx::dynamics::solid
