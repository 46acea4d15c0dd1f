// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "core/progress.h"

#include <functional>
#include <string>

namespace sphinx::io {

struct ProgressParameters {
    bool live = false;      ///< on a terminal: one line, rewritten in place; else a line each time
    std::string time_unit;  ///< empty: none
};

/// True when the run's messages go to a terminal.
bool onTerminal();

/// Tells how far the run has come, to the log and on the screen.
class ProgressOutput final : public Output {
 public:
    ProgressOutput(ProgressParameters parameters, std::function<Progress()> progress)
        : parameters_(std::move(parameters)), progress_(std::move(progress)) {}

    FileWork take(const Clock& clock) override;
    void finish() override;

 private:
    ProgressParameters parameters_;
    std::function<Progress()> progress_;
};

/// "time 1.25 s of 20 s (6.2 %), step 1200, dt 0.0031 s, 812 steps/s, 0:18:45 left"
std::string progressText(const Progress& progress, const std::string& time_unit);
/// "0:01:35", "2 days 3:00:00"
std::string durationText(double seconds);

}  // namespace sphinx::io
