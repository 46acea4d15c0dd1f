// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "../temporary_folder.h"
#include "core/errors.h"
#include "fakes.h"
#include "loop/run/runner.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

void sleepFor(int microseconds) {
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
}

double sum(const std::vector<ProfileLine>& lines) {
    double seconds = 0;
    for (const ProfileLine& line : lines) seconds += line.seconds;
    return seconds;
}

/// A profile with round numbers.
Profile plain() {
    Profile profile;
    profile.time = 2.5;
    profile.finished = true;
    profile.loop_seconds = 8;
    profile.start_seconds = 0.5;
    profile.output_seconds = 1;
    profile.writing_seconds = 2;
    profile.steps = {{"advection", 10}, {"acoustic", 50}};
    const ProfileLine dt{"acoustic_dt", "time_step", 50, 1, 2.0, 0, {}};
    const ProfileLine half{"pressure \"relaxation\"", "call", 50, 4, 16.5, 0, {}};
    const ProfileLine acoustic{"acoustic", "layer", 50, 6, {}, 0, {dt, half}};
    profile.lines = {{"advection", "layer", 10, 8, {}, 0, {acoustic}}};
    profile.start = {{"neighbors", "start", 1, 0.5, 100.0, 0, {}}};
    profile.outputs = {{"fields", "output", 3, 1, {}, 0, {}}};
    profile.writing = {{"fields", "writing", 3, 2, {}, 0, {}}};
    setShares(profile);
    return profile;
}

}  // namespace

TEST_CASE("the profile has the shape of the loop, and its times add up") {
    Acting short_call([](const Clock&) { sleepFor(200); });
    Acting long_call([](const Clock&) { sleepFor(400); });
    Estimate dt([] {
        sleepFor(100);
        return 0.5;
    });
    Journal journal;
    RecordingOutput output("frames", journal);
    output.on_take = [] { sleepFor(300); };
    output.on_write = [] { sleepFor(200); };
    Plan plan;
    plan.end_time = 5;
    plan.start = {acting("lists", short_call)};
    const Layer inner{"inner", {{{"inner_dt"}, &dt}}, {}, Fit::split, {call("long", long_call)}};
    plan.outermost = fixedLayer(
        "outer", 1, {call("short", short_call), {inner}, every("rare", short_call, eachSteps(2))});
    plan.outputs = {{"frames", "vtu", &output, eachSteps(1), false}};
    Runner runner(plan);
    runAll(runner, [](const Clock&) {
        sleepFor(100);
        return std::nullopt;
    });

    const Profile profile = runner.profile();
    CHECK(profile.steps == decltype(profile.steps){{"outer", 5}, {"inner", 10}});
    REQUIRE(profile.lines.size() == 2);
    const ProfileLine& outer = profile.lines[0];
    const ProfileLine& checks = profile.lines[1];
    CHECK(outer.label == "outer");
    CHECK(outer.kind == "layer");
    REQUIRE(outer.lines.size() == 3);
    CHECK(outer.lines[0].label == "short");
    CHECK(outer.lines[0].calls == 5);
    CHECK(outer.lines[1].label == "inner");
    CHECK(outer.lines[1].calls == 10);
    REQUIRE(outer.lines[1].lines.size() == 2);
    CHECK(outer.lines[1].lines[0].label == "inner_dt");
    CHECK(outer.lines[1].lines[0].kind == "time_step");
    CHECK(outer.lines[1].lines[0].calls == 10);
    CHECK(outer.lines[1].lines[1].label == "long");
    CHECK(outer.lines[2].label == "rare");
    CHECK(outer.lines[2].calls == 2);
    CHECK(checks.calls == 5);

    // Lower bounds by the sleeps, upper bounds by what contains them.
    CHECK(outer.lines[0].seconds >= 5 * 200e-6);
    CHECK(outer.lines[1].lines[1].seconds >= 10 * 400e-6);
    CHECK(checks.seconds >= 5 * 100e-6);
    // One read of the clock ends a line and begins the next: nothing is lost between lines.
    CHECK(sum(outer.lines[1].lines) == Approx(outer.lines[1].seconds).epsilon(1e-12));
    CHECK(sum(outer.lines) == Approx(outer.seconds).epsilon(1e-12));
    CHECK(sum(profile.lines) <= profile.loop_seconds);
    CHECK(outer.lines[1].share == outer.lines[1].seconds / profile.loop_seconds);
    // 10 calls on one particle each.
    CHECK(*outer.lines[1].lines[1].nanoseconds_per_particle ==
          Approx(1e9 * outer.lines[1].lines[1].seconds / 10));
    CHECK_FALSE(outer.nanoseconds_per_particle);

    // Outputs and start stand beside the loop.
    CHECK(profile.outputs[0].calls == 6);
    CHECK(profile.output_seconds >= 6 * 300e-6);
    CHECK(profile.writing[0].calls == 6);
    CHECK(profile.writing_seconds >= 6 * 200e-6);
    CHECK(profile.start[0].calls == 1);
    CHECK(profile.start_seconds >= 200e-6);
    CHECK(profile.finished);
}

TEST_CASE("the profile as a table") {
    std::string table;
    for (const std::string& line : profileTable(plain())) table += line + "\n";
    CHECK(table ==
          "profile                         calls      seconds  ns/particle    share\n"
          "advection                          10        8.000                100.0%\n"
          "  acoustic                         50        6.000                 75.0%\n"
          "    dt: acoustic_dt                50        1.000          2.0    12.5%\n"
          "    pressure \"relaxation\"          50        4.000         16.5    50.0%\n"
          "start                                        0.500\n"
          "  neighbors                         1        0.500        100.0     6.2%\n"
          "outputs                                      1.000\n"
          "  fields                            3        1.000                 12.5%\n"
          "writing them meanwhile                       2.000\n"
          "  fields                            3        2.000                 25.0%\n");
}

TEST_CASE("the profile as JSON") {
    const std::string json = profileJson(plain());
    CHECK(json.starts_with(R"({
  "time": 2.5,
  "finished": true,
  "loop_seconds": 8,
  "start_seconds": 0.5,
  "output_seconds": 1,
  "writing_seconds": 2,
  "steps": {
    "advection": 10,
    "acoustic": 50
  },
  "lines": [
    {
      "label": "advection",
      "kind": "layer",
      "calls": 10,
      "seconds": 8,
      "ns_per_particle": null,
      "share": 1,
      "lines": [
        {
          "label": "acoustic",
)"));
    CHECK_THAT(json, Catch::Contains(R"(
            {
              "label": "pressure \"relaxation\"",
              "kind": "call",
              "calls": 50,
              "seconds": 4,
              "ns_per_particle": 16.5,
              "share": 0.5,
              "lines": []
            }
)"));
    CHECK(json.ends_with(R"(
  "outputs": [
    {
      "label": "fields",
      "kind": "output",
      "calls": 3,
      "seconds": 1,
      "ns_per_particle": null,
      "share": 0.125,
      "lines": []
    }
  ],
  "writing": [
    {
      "label": "fields",
      "kind": "writing",
      "calls": 3,
      "seconds": 2,
      "ns_per_particle": null,
      "share": 0.25,
      "lines": []
    }
  ]
}
)"));

    const test::TemporaryFolder folder;
    const auto path = folder / "profile.json";
    writeProfile(plain(), path);
    std::ostringstream read;
    read << std::ifstream(path).rdbuf();
    CHECK(read.str() == json);
    CHECK_THROWS_AS(writeProfile(plain(), "/nonexistent/profile.json"), FileError);
}

TEST_CASE("the profile tells how many iterations a solver took") {
    Profile profile = plain();
    CHECK(profileJson(profile).find("iterations") == std::string::npos);
    profile.lines[0].lines[0].lines[1].iterations = 125;
    CHECK(profileJson(profile).find("\"iterations\": 125") != std::string::npos);
    const std::vector<std::string> table = profileTable(profile);
    CHECK(std::count_if(table.begin(), table.end(), [](const std::string& row) {
              return row.find("  2.5 iterations a call") != std::string::npos;
          }) == 1);
}
