// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/trigger.h"
#include "fakes.h"

#include <catch2/catch.hpp>

using namespace sphinx::loop;

TEST_CASE("a multiple is reached once, however many were passed") {
    Multiples next(0.5);
    next.startAfter(0);
    CHECK_FALSE(next.reach(0.25));
    CHECK(next.reach(0.5));
    CHECK_FALSE(next.reach(0.75));
    CHECK(next.reach(2.25));  // passed 1.0, 1.5 and 2.0
    CHECK_FALSE(next.reach(2.375));
    CHECK(next.reach(2.5));
}

TEST_CASE("multiples start above the present value") {
    Multiples next(2);
    next.startAfter(6);
    CHECK_FALSE(next.reach(7));
    CHECK(next.reach(8));
    Multiples negative(2);
    negative.startAfter(-3);
    CHECK(negative.reach(-2));
}

TEST_CASE("every multiple of a decimal interval is reached exactly once by its own value") {
    Multiples next(0.1);
    next.startAfter(0);
    for (int k = 1; k < 100000; ++k) {
        REQUIRE(next.reach(k * 0.1));
        REQUIRE_FALSE(next.reach(k * 0.1));
    }
}

TEST_CASE("an interval below the resolution of the value is reached by every value") {
    Multiples next(1e-300);
    next.startAfter(0);
    CHECK(next.reach(1));
    CHECK(next.reach(2));
}

TEST_CASE("the state of a trigger survives saving") {
    Multiples next(3);
    CHECK(next.reach(10));
    fake::MemoryArchive out;
    next.transfer(out);
    Multiples again(3);
    fake::MemoryArchive in(out.saved);
    again.transfer(in);
    CHECK_FALSE(again.reach(11));
    CHECK(again.reach(12));
}

TEST_CASE("triggers are described exactly") {
    CHECK(describe(fake::eachTime(0.1)) == "time 0.1");
    CHECK(describe(fake::eachSteps(100)) == "steps 100");
    CHECK(describe(fake::eachSteps(20, "acoustic")) == "steps 20 of acoustic");
    CHECK(describe({Trigger::Kind::wall_time, 1800, ""}) == "wall_time 1800");
    CHECK(describe(fake::eachTime(0.1 + 0.2)) == "time 0.30000000000000004");
}
