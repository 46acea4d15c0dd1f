// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sphinx::run {

/// What SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2 and SIGXCPU do while it lives, unless they were
/// ignored when the program started. At first they end the process at once, with exit code
/// 128 + the signal; after remember() they are remembered instead, and a second one ends the
/// process. A terminal or pipe that goes away (SIGPIPE) does not end the run, and a file that may
/// not grow (SIGXFSZ) is a FileError of the one who writes it.
class SignalGuard {
 public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

    /// From now on there is something to bring to an end: files are being written.
    void remember();
    /// The signal that came since then, or 0.
    static int received();
};

}  // namespace sphinx::run
