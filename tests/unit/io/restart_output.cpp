// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/restart/output.h"

#include "support.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

TEST_CASE("the newest restarts stay, and the newest valid one is found") {
    TemporaryFolder folder;
    auto body = makeBody<2>("water", 9);
    RestartParameters parameters;
    parameters.folder = folder / "restart";
    parameters.keep = 3;
    parameters.header.case_name = "tank";
    RestartOutput<2> output(parameters, {{body.get(), {}}}, [](Archive&) {});
    CHECK(findNewestValid(parameters.folder).found.empty());
    const auto names = [&] {
        std::vector<std::string> result;
        for (const auto& entry : std::filesystem::directory_iterator(parameters.folder))
            result.push_back(entry.path().filename().string());
        std::sort(result.begin(), result.end());
        return result;
    };
    for (const std::int64_t steps : {8, 9, 10, 100, 101}) {
        Clock clock;
        clock.steps = steps;
        output.write(clock);
    }
    CHECK(names() == std::vector<std::string>{"tank_10.xml", "tank_100.xml", "tank_101.xml"});

    File::openUpdate(parameters.folder / "tank_101.xml").truncate(500);
    const RestartSearch search = findNewestValid(parameters.folder);
    CHECK(search.found == parameters.folder / "tank_100.xml");
    REQUIRE(search.skipped.size() == 1);
    CHECK(search.skipped[0].first == parameters.folder / "tank_101.xml");
    CHECK_THAT(search.skipped[0].second, Catch::Contains("cut short"));

    File::create(parameters.folder / "tank_102.xml.tmp").write("unfinished");
    Clock clock;
    clock.steps = 100;
    output.resume(clock);
    CHECK(names() == std::vector<std::string>{"tank_10.xml", "tank_100.xml"});
}
