// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "core/timer.h"
#include "io/restart/restart.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sphinx::io {

/// A copy in memory of what a restart would hold, some steps old: when a step fails in its midst,
/// the fields themselves are good for nothing any more. It is taken anew after each step as long
/// as all copies take no more than a two-hundredth of the time of the run.
template <int Dim>
class HeldRestart {
 public:
    HeldRestart(Path folder, RestartHeader header, std::vector<RestartBody<Dim>> bodies,
                StateTransfer state);

    /// After a step, when its outputs have written: takes the state, if it is time.
    void hold(const Clock& clock);
    /// Writes what is held as a file beside the others, unless one of this state or of a later one
    /// is there. Returns the time of the newest state in the folder; nothing where none is held.
    /// Throws FileError.
    std::optional<double> write() const;

 private:
    void copy(const RestartBody<Dim>& from, RestartBody<Dim>& to);

    Path folder_;
    RestartHeader header_;
    std::vector<RestartBody<Dim>> bodies_;
    StateTransfer state_;
    std::vector<std::unique_ptr<bodies::Body<Dim>>> own_;  // name, ids and fields only
    std::vector<RestartBody<Dim>> copies_;
    std::string state_text_;
    bool holds_ = false;
    Timer running_;
    double cost_ = 0;   // of the last copy, seconds
    double spent_ = 0;  // on all of them
};

}  // namespace sphinx::io
