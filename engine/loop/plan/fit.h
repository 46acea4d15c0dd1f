// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sphinx::loop {

/// How the substeps of an inner layer fill its parent's interval.
enum class Fit {
    split,      ///< equal parts of what remains, none above the estimate
    clip,       ///< the estimate, the last substep is cut
    overshoot,  ///< the estimate; the parent's interval becomes what was covered
};

struct Substep {
    double dt = 0;
    double end = 0;  ///< time after the substep; the last one of split and clip ends at `until`
};

/// Times differ from the sums that they should be by rounding. What is missing to a target counts
/// as rounding below this part of a substep, so that ten steps of 0.1 reach 1.
inline constexpr double rounding_part = 1e-6;

/// Whether a layer whose last substep had size dt has come to `target`.
inline bool reached(double time, double dt, double target) {
    return time + rounding_part * dt >= target;
}

/// The next substep of a layer that stands at `time` and covers its parent's interval up to
/// `until` > time; `estimate` > 0. Callers check that `end` is above `time`.
Substep fitSubstep(Fit fit, double time, double until, double estimate);

}  // namespace sphinx::loop
