// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace sphinx {

/// Wall-clock seconds since construction or the last restart().
class Timer {
 public:
    double seconds() const { return std::chrono::duration<double>(Now::now() - start_).count(); }
    void restart() { start_ = Now::now(); }

 private:
    using Now = std::chrono::steady_clock;
    Now::time_point start_ = Now::now();
};

}  // namespace sphinx
