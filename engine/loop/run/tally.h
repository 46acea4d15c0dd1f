// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

namespace sphinx::loop {

/// What one line of the loop has cost so far.
struct Tally {
    std::int64_t calls = 0;
    std::int64_t nanoseconds = 0;
    double particles = 0;  ///< sum over the calls of the particles worked on

    double seconds() const { return 1e-9 * static_cast<double>(nanoseconds); }
};

/// Adds one call and its duration to a tally: two reads of the clock.
class TimedCall {
 public:
    explicit TimedCall(Tally& tally) : tally_(tally), start_(Now::now()) { ++tally.calls; }
    ~TimedCall() {
        tally_.nanoseconds +=
            std::chrono::duration_cast<std::chrono::nanoseconds>(Now::now() - start_).count();
    }
    TimedCall(const TimedCall&) = delete;
    TimedCall& operator=(const TimedCall&) = delete;

 private:
    using Now = std::chrono::steady_clock;
    Tally& tally_;
    Now::time_point start_;
};

}  // namespace sphinx::loop
