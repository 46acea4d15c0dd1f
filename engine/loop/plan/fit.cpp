// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/fit.h"

#include <cmath>

namespace sphinx::loop {

Substep fitSubstep(Fit fit, double time, double until, double estimate) {
    if (fit == Fit::overshoot) return {estimate, time + estimate};
    const double remaining = until - time;
    if (remaining <= estimate * (1 + rounding_part)) return {remaining, until};
    const double dt =
        fit == Fit::clip ? estimate : remaining / std::ceil(remaining / estimate - rounding_part);
    return {dt, time + dt};
}

}  // namespace sphinx::loop
