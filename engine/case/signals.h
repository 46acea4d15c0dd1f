// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sphinx::model {

/// While it lives, SIGINT and SIGTERM are remembered instead of ending the process. A second one
/// ends it at once. A terminal or pipe that goes away (SIGPIPE) does not end the run.
class SignalGuard {
 public:
    SignalGuard();
    ~SignalGuard();
    SignalGuard(const SignalGuard&) = delete;
    SignalGuard& operator=(const SignalGuard&) = delete;

    /// The signal that came, or 0.
    static int received();
};

}  // namespace sphinx::model
