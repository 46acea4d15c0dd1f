// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bodies/role.h"

namespace sphinx::model {

/// Smoothing length over spacing, h / dp, of a body where neither it nor the case states one.
/// Elastic bodies have the ratio at which beams of few rows of particles bend, swing and twist with
/// the least error: dynamics/solid/README.md.
double defaultSmoothingRatio(bodies::Role role);

}  // namespace sphinx::model
