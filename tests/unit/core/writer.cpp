// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/writer.h"

#include "core/parallel.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace sphinx;

namespace {

constexpr std::size_t large = std::size_t{1} << 30;  // of which two are there at most

}  // namespace

TEST_CASE("a writer does its work in order, on one other thread") {
    std::vector<int> done, loop_threads;
    std::vector<std::thread::id> threads;
    Writer writer;
    for (int k = 0; k < 100; ++k)
        writer.add(
            [&, k] {
                done.push_back(k);
                threads.push_back(std::this_thread::get_id());
                loop_threads.push_back(threadCount());
            },
            0);
    writer.finish();
    REQUIRE(done.size() == 100);
    for (int k = 0; k < 100; ++k) CHECK(done[static_cast<std::size_t>(k)] == k);
    for (const std::thread::id thread : threads) CHECK(thread == threads[0]);
    for (const int count : loop_threads) CHECK(count == 1);
    CHECK(threads[0] != std::this_thread::get_id());
    writer.finish();
}

TEST_CASE("a writer does what is left when it ends") {
    int done = 0;
    {
        Writer writer;
        for (int k = 0; k < 10; ++k) writer.add([&] { ++done; }, 0);
    }
    CHECK(done == 10);
}

TEST_CASE("a writer that fails does no more and says so each time") {
    std::atomic<int> done = 0;
    Writer writer;
    writer.add([&] { ++done; }, 0);
    writer.add([] { throw std::runtime_error("no"); }, large);
    CHECK_THROWS_WITH(writer.finish(), "no");
    CHECK_THROWS_WITH(writer.check(), "no");
    CHECK_THROWS_WITH(writer.waitForRoom(), "no");
    CHECK_THROWS_WITH(writer.add([&] { ++done; }, 0), "no");
    CHECK(done == 1);
}

TEST_CASE("a writer holds two large pieces at most") {
    std::atomic<int> there = 0, most = 0;
    Writer writer;
    for (int k = 0; k < 20; ++k) {
        writer.waitForRoom();
        const int now = ++there;
        if (now > most) most = now;
        writer.add([&] { --there; }, large);
    }
    writer.finish();
    CHECK(there == 0);
    CHECK(most <= 2);
}
