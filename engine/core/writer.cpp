// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/writer.h"

#include "core/errors.h"
#include "core/parallel.h"

#include <algorithm>
#include <csignal>
#include <system_error>
#include <utility>

namespace sphinx {
namespace {

constexpr std::size_t little = std::size_t{16} << 20;

/// Signals are for the thread that steps. A new thread inherits what its maker blocks.
class WithoutSignals {
 public:
    WithoutSignals() {
        sigset_t all;
        ::sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~WithoutSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    WithoutSignals(const WithoutSignals&) = delete;
    WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
    sigset_t before_;
};

}  // namespace

Writer::~Writer() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    came_.notify_one();
    thread_.join();
}

void Writer::throwFailure() {
    if (failure_) std::rethrow_exception(failure_);
}

void Writer::waitForRoom() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return failure_ || bytes_ <= std::max(little, largest_); });
    throwFailure();
}

void Writer::add(std::function<void()> work, std::size_t bytes) {
    {
        const std::lock_guard lock(mutex_);
        throwFailure();
        pieces_.push_back({std::move(work), bytes});
        bytes_ += bytes;
        largest_ = std::max(largest_, bytes);
    }
    came_.notify_one();
    if (thread_.joinable()) return;
    try {
        const WithoutSignals blocked;
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error& error) {
        throw FileError(std::string("cannot start the thread that writes: ") + error.what());
    }
}

void Writer::finish() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return failure_ || pieces_.empty(); });
    throwFailure();
}

void Writer::check() {
    const std::lock_guard lock(mutex_);
    throwFailure();
}

void Writer::run() {
    workAlone();
    std::unique_lock lock(mutex_);
    for (;;) {
        came_.wait(lock, [&] { return ends_ || !pieces_.empty(); });
        if (pieces_.empty()) return;
        Piece& piece = pieces_.front();  // the place stays where more are added behind it
        std::exception_ptr failure;
        lock.unlock();
        try {
            piece.work();
        } catch (...) {
            failure = std::current_exception();
        }
        piece.work = nullptr;  // and what it held
        lock.lock();
        failure_ = failure;
        if (failure_) {
            pieces_.clear();
            bytes_ = 0;
            done_.notify_all();
            return;
        }
        bytes_ -= piece.bytes;
        pieces_.pop_front();
        done_.notify_all();
    }
}

}  // namespace sphinx
