// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"

#include <cstdint>
#include <string>

namespace sphinx::loop {

/// `every:` of an output or of a call: a moment comes when a multiple of the interval is reached.
struct Trigger {
    enum class Kind { time, steps, wall_time };

    Kind kind = Kind::steps;
    double interval = 1;  ///< above 0; time: case units, steps: a whole number, wall_time: seconds
    std::string layer;    ///< steps only: the layer that counts; empty means the outermost
};

/// "time 0.1", "steps 100 of acoustic", "wall_time 1800": exact, so that equal texts mean equal
/// triggers.
std::string describe(const Trigger& trigger);

/// Remembers which multiple of an interval comes next.
class Multiples {
 public:
    explicit Multiples(double interval) : interval_(interval) {}

    /// The next multiple is the first one above `value`.
    void startAfter(double value);
    /// True when `value` has come to the next multiple: once, however many were passed.
    bool reach(double value);

    void transfer(Archive& archive) { archive.value("next", next_); }

 private:
    double interval_;
    std::int64_t next_ = 1;
};

}  // namespace sphinx::loop
