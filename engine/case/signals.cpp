// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/signals.h"

#include <csignal>

namespace sphinx::model {
namespace {

volatile std::sig_atomic_t received_signal = 0;

void remember(int signal) {
    received_signal = signal;
    std::signal(signal, SIG_DFL);
}

}  // namespace

SignalGuard::SignalGuard() {
    received_signal = 0;
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
    std::signal(SIGPIPE, SIG_IGN);
}

SignalGuard::~SignalGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

int SignalGuard::received() { return received_signal; }

}  // namespace sphinx::model
