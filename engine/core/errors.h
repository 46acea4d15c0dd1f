// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace sphinx {

/// Exit codes of the executable.
enum ExitCode : int {
    exit_done = 0,
    exit_program_faulty = 1,
    exit_case_wrong = 2,
    exit_physics_failed = 3,
    exit_files_failed = 4,
};

/// The case or the command line is wrong; the message is complete and ready to print.
struct CaseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The physics failed (NaN, lost particle, inverted element); the message names particle, place,
/// method and time.
struct PhysicsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reading or writing a file failed; the message names the file and the cause.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace sphinx
