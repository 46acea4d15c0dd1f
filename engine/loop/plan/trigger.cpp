// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/trigger.h"

#include <fmt/format.h>

#include <cmath>

namespace sphinx::loop {

std::string describe(const Trigger& trigger) {
    switch (trigger.kind) {
        case Trigger::Kind::time: return fmt::format("time {}", trigger.interval);
        case Trigger::Kind::wall_time: return fmt::format("wall_time {}", trigger.interval);
        case Trigger::Kind::steps: break;
    }
    const std::string of = trigger.layer.empty() ? "" : " of " + trigger.layer;
    return fmt::format("steps {}{}", trigger.interval, of);
}

void Multiples::startAfter(double value) {
    // Beyond this a multiple is no longer a distinct number; from there every step reaches one.
    constexpr double countable = 9007199254740992.0;  // 2^53
    const double ratio = value / interval_;
    if (!(std::abs(ratio) < countable)) return;
    auto k = static_cast<std::int64_t>(std::floor(ratio));
    // The quotient is rounded, the products decide.
    while (static_cast<double>(k) * interval_ > value) --k;
    while (static_cast<double>(k + 1) * interval_ <= value) ++k;
    next_ = k + 1;
}

bool Multiples::reach(double value) {
    if (!(value >= static_cast<double>(next_) * interval_)) return false;
    startAfter(value);
    return true;
}

}  // namespace sphinx::loop
