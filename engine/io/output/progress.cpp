// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/output/progress.h"

#include "core/log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace sphinx::io {
namespace {

/// "[######------]"
std::string bar(double fraction) {
    constexpr int width = 20;
    const int done = static_cast<int>(std::lround(width * std::fmin(std::fmax(fraction, 0), 1)));
    return "[" + std::string(done, '#') + std::string(width - done, '-') + "]";
}

}  // namespace

bool onTerminal() { return ::isatty(STDOUT_FILENO) == 1; }

std::string durationText(double seconds) {
    if (!(seconds < 1e9)) return "unknown time";
    const auto whole = static_cast<long long>(std::ceil(std::fmax(seconds, 0)));
    const long long days = whole / 86400;
    std::string text;
    if (days > 0) text = fmt::format("{} day{} ", days, days > 1 ? "s" : "");
    return text + fmt::format("{}:{:02}:{:02}", whole / 3600 % 24, whole / 60 % 60, whole % 60);
}

std::string progressText(const Progress& progress, const std::string& time_unit) {
    const std::string unit = time_unit.empty() ? "" : " " + time_unit;
    std::string text =
        fmt::format("time {:.6g}{} of {:.6g}{} ({:.1f} %), step {}", progress.time, unit,
                    progress.end_time, unit, 100 * progress.fraction, progress.steps);
    if (progress.steps_per_second > 0)
        text += fmt::format(", dt {:.3g}{}, {:.3g} steps/s, {} left", progress.dt, unit,
                            progress.steps_per_second, durationText(progress.seconds_left));
    return text;
}

FileWork ProgressOutput::take(const Clock&) {
    const Progress now = progress_();
    const std::string text = progressText(now, parameters_.time_unit);
    if (!parameters_.live) {
        log::info(text);
        return {};
    }
    log::status(bar(now.fraction) + " " + text);
    log::fileOnly(text);
    return {};
}

void ProgressOutput::finish() {
    if (parameters_.live) log::status("");
}

}  // namespace sphinx::io
