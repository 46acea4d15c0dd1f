// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <cerrno>
#include <memory>
#include <string>
#include <system_error>

namespace sphinx {
namespace {

struct Pool {
    int threads = 1;
    std::unique_ptr<tbb::global_control> limit;
    std::unique_ptr<tbb::task_arena> arena;
};

Pool& pool() {
    static Pool instance;
    return instance;
}

thread_local bool works_alone = false;

/// Where the system has no more of them that is told here, and not in the midst of a step.
void startThreads() {
    const int threads = pool().threads;
    try {
        detail::runRanges(
            static_cast<std::size_t>(threads), 1, [](void*, std::size_t, std::size_t) {}, nullptr);
    } catch (const std::exception&) {
        throw std::system_error(EAGAIN, std::generic_category(),
                                "cannot start " + std::to_string(threads) + " threads");
    }
}

}  // namespace

void setThreadCount(int threads) {
    Pool& p = pool();
    p.threads = threads > 0 ? threads : tbb::info::default_concurrency();
    p.arena.reset();
    p.limit.reset();
    if (p.threads > 1) {
        // An explicit limit above the machine's own count is honoured: results are the same.
        p.limit = std::make_unique<tbb::global_control>(
            tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(p.threads));
        p.arena = std::make_unique<tbb::task_arena>(p.threads);
        p.arena->initialize();
        startThreads();
    }
}

int threadCount() { return works_alone ? 1 : pool().threads; }

void workAlone() { works_alone = true; }

namespace detail {

void runRanges(std::size_t n, std::size_t grain, RangeFunction function, void* context) {
    pool().arena->execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, n, grain),
            [&](const tbb::blocked_range<std::size_t>& r) {
                function(context, r.begin(), r.end());
            },
            tbb::simple_partitioner());
    });
}

}  // namespace detail
}  // namespace sphinx
