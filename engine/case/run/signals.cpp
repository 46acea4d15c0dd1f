// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/run/signals.h"

#include <unistd.h>

#include <csignal>
#include <string_view>

namespace sphinx::run {
namespace {

volatile std::sig_atomic_t received_signal = 0;
volatile std::sig_atomic_t remembers = 0;

// Only what a signal handler may call.
void handle(int signal) {
    if (!remembers) {
        constexpr std::string_view line = "stopped before the first step; nothing was written\n";
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
        ::_exit(128 + signal);
    }
    received_signal = signal;
    std::signal(signal, SIG_DFL);
}

}  // namespace

SignalGuard::SignalGuard() {
    received_signal = 0;
    remembers = 0;
    std::signal(SIGINT, handle);
    std::signal(SIGTERM, handle);
    std::signal(SIGPIPE, SIG_IGN);
}

SignalGuard::~SignalGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

void SignalGuard::remember() { remembers = 1; }

int SignalGuard::received() { return received_signal; }

}  // namespace sphinx::run
