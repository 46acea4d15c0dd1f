// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace sphinx {

/// How far a run has come.
struct Progress {
    double time = 0;              ///< case units
    double end_time = 0;          ///< case units
    double fraction = 0;          ///< of the interval from start to end time; 0 to 1
    std::int64_t steps = 0;       ///< outermost steps since the start of the run
    double dt = 0;                ///< last outermost step, case units
    double seconds = 0;           ///< wall clock of this process since its first step
    double steps_per_second = 0;  ///< outermost steps, mean over this process; 0 before the first
    double seconds_left = 0;      ///< at the mean pace of this process; NaN before the first step
};

}  // namespace sphinx
