// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/rules.h"

namespace sphinx::dynamics::solid {

/// Of the methods that the rule is about.
struct StressRelaxationParameters {
    input::Name body;
    bool hourglass_control = true;
    bool damping = true;
};

struct StressUpdateParameters {
    input::Name body;
    bool hourglass_control = true;
};

/// A rule of methods that step an elastic body: a body has one hourglass control, by whichever of
/// them it is stepped.
void checkHourglassControl(const input::Component& method, WrittenCase& written);

}  // namespace sphinx::dynamics::solid
