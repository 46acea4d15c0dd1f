// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace sphinx::run {

struct RunOptions {
    std::string output;  ///< results folder; empty: output/NAME below the present folder
    int threads = 0;     ///< 0: all of the machine
    bool overwrite = false;
    bool resume = false;               ///< go on from the newest valid restart in the folder
    std::string restart;               ///< go on from this restart file
    std::optional<double> time_limit;  ///< seconds of wall clock, then a restart is written
    bool outputs = true;               ///< false: nothing but the log is written
};

}  // namespace sphinx::run
