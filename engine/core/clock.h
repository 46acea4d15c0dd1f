// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"

#include <cstdint>

namespace sphinx {

/// Time of one layer of the loop. Methods read it; only the layer advances it.
struct Clock {
    double time = 0;         ///< start of the current substep, case units
    double dt = 0;           ///< size of the current substep, case units
    std::int64_t steps = 0;  ///< substeps completed since the start of the run
    /// Start of the interval that the layer covers, a step of the layer around it; for the
    /// outermost layer of its own step. Set anew in every step, so no state.
    double interval_start = 0;
    /// In the calls of `start` there is no step yet, and dt means nothing.
    bool is_start = false;

    void transfer(Archive& archive) {
        archive.value("time", time);
        archive.value("dt", dt);
        archive.count("steps", steps);
    }
};

}  // namespace sphinx
