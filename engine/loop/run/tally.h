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

/// Shares time out among lines that act one after the other: one read of the clock ends a line and
/// begins the next.
class Laps {
 public:
    /// What has passed since the last line belongs to none.
    void begin() { last_ = now(); }
    /// Of a line that has acted since the last one, or since begin().
    void end(Tally& tally) {
        const std::int64_t before = last_;
        last_ = now();
        ++tally.calls;
        tally.nanoseconds += last_ - before;
    }
    /// When the last line ended; nanoseconds since some moment.
    std::int64_t last() const { return last_; }

 private:
    static std::int64_t now() {
        using std::chrono::nanoseconds;
        const auto since = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration_cast<nanoseconds>(since).count();
    }
    std::int64_t last_ = 0;
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
