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

/// What batch systems and terminals send to end a program.
constexpr int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU};

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
    for (const int signal : ending) {
        const auto before = std::signal(signal, handle);
        // nohup, or a shell that runs it in the background: it stays so.
        if (before == SIG_IGN) std::signal(signal, SIG_IGN);
    }
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

SignalGuard::~SignalGuard() {
    for (const int signal : ending) std::signal(signal, SIG_DFL);
}

void SignalGuard::remember() { remembers = 1; }

int SignalGuard::received() { return received_signal; }

}  // namespace sphinx::run
