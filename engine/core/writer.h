// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace sphinx {

/// Does pieces of work on one thread of its own, in the order in which they come, while the caller
/// goes on. When one throws, none is begun any more, and every later call throws the same.
class Writer {
 public:
    Writer() = default;
    /// Does what is left; nobody hears of a failure then.
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Called before what the next piece holds is copied: waits until what is not done yet holds
    /// little, or no more than the largest piece so far. So two large copies are there at most.
    void waitForRoom();
    /// `bytes`: of memory that the piece holds.
    void add(std::function<void()> work, std::size_t bytes);
    /// Returns when all is done.
    void finish();
    /// Throws what a piece has thrown.
    void check();

 private:
    struct Piece {
        std::function<void()> work;
        std::size_t bytes;
    };

    void run();
    void throwFailure();

    std::mutex mutex_;
    std::condition_variable came_, done_;
    std::deque<Piece> pieces_;  // the first one is under way
    std::size_t bytes_ = 0;     // of all of them
    std::size_t largest_ = 0;   // piece so far
    std::exception_ptr failure_;
    bool ends_ = false;
    std::thread thread_;  // begins with the first piece
};

}  // namespace sphinx
