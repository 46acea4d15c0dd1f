// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/run/runner.h"
#include "core/errors.h"
#include "fakes.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

const Stop go_on = [](const Clock&) { return std::nullopt; };

struct Frames {
    Journal journal;
    RecordingOutput output{"frame", journal};

    OutputEntry entry(std::optional<Trigger> every, bool restart = false) {
        return {"frames", "vtu", &output, std::move(every), restart};
    }
    std::vector<double> times() const {
        std::vector<double> all;
        for (const Event& event : journal) all.push_back(event.time);
        return all;
    }
};

}  // namespace

TEST_CASE("a run ends after the first step that reaches the end time") {
    Plan plan = planUntil(1.1, fixedLayer("outer", 0.25, {}));
    Runner runner(plan);
    int steps = 0;
    const Outcome outcome = runAll(runner, [&](const Clock& clock) {
        CHECK(clock.steps == ++steps);
        return std::nullopt;
    });
    CHECK(outcome.finished);
    CHECK(runner.clock().time == 1.25);
    CHECK(runner.clock().dt == 0.25);
    CHECK(steps == 5);
}

TEST_CASE("ten steps of 0.1 reach an end time of 1") {
    Plan plan = planUntil(1, fixedLayer("outer", 0.1, {}));
    Runner runner(plan);
    runAll(runner, go_on);
    CHECK(runner.clock().steps == 10);
}

TEST_CASE("start calls run once, before the first frame") {
    Frames frames;
    Recorder lists("lists", frames.journal);
    Plan plan;
    plan.start_time = 2;
    plan.end_time = 3;
    plan.start = {acting("lists", lists)};
    plan.outermost = fixedLayer("outer", 1, {});
    plan.outputs = {frames.entry({})};
    Runner runner(plan);
    runAll(runner, go_on);
    CHECK(frames.journal == Journal{{"lists", 2, 0, 0}, {"frame", 2, 0, 0}, {"frame", 3, 1, 1}});
    CHECK(frames.output.finished == 1);
}

TEST_CASE("outputs fire at the start, once for all multiples passed, and at the end") {
    Frames frames;
    Plan plan = planUntil(2.75, fixedLayer("outer", 0.75, {}), {frames.entry(eachTime(0.5))});
    Runner runner(plan);
    runAll(runner, go_on);
    // 0.75 passes 0.5; 1.5 passes 1 and 1.5; 2.25 passes 2; 3 reaches 2.5 and 3.
    CHECK(frames.times() == std::vector<double>{0, 0.75, 1.5, 2.25, 3});

    Frames rare;
    plan.outputs = {rare.entry(eachTime(2))};
    Runner again(plan);
    runAll(again, go_on);
    CHECK(rare.times() == std::vector<double>{0, 2.25, 3});
}

TEST_CASE("outputs count outermost steps, or those of a layer") {
    Frames frames;
    Plan plan = planUntil(5, fixedLayer("outer", 1, {{fixedLayer("inner", 0.25, {})}}),
                          {frames.entry(eachSteps(2))});
    runAll(Runner(plan), go_on);
    CHECK(frames.times() == std::vector<double>{0, 2, 4, 5});

    frames.journal.clear();
    plan.outputs = {frames.entry(eachSteps(6, "inner"))};
    runAll(Runner(plan), go_on);
    CHECK(frames.times() == std::vector<double>{0, 2, 3, 5});  // 8, 12 and 20 substeps
}

TEST_CASE("an interval of wall time") {
    Frames frames;
    Plan plan = planUntil(3, fixedLayer("outer", 1, {}),
                          {frames.entry(Trigger{Trigger::Kind::wall_time, 1e-12, ""}, true)});
    runAll(Runner(plan), go_on);
    CHECK(frames.times() == std::vector<double>{1, 2, 3});

    frames.journal.clear();
    plan.outputs = {frames.entry(Trigger{Trigger::Kind::wall_time, 1e6, ""}, true)};
    runAll(Runner(plan), go_on);
    CHECK(frames.times() == std::vector<double>{3});
}

TEST_CASE("restarts are written last, not at the start, and know of their own writing") {
    Journal journal;
    RecordingOutput restart("restart", journal), frame("frame", journal);
    Plan plan = planUntil(2, fixedLayer("outer", 1, {}),
                          {{"restart", "restart", &restart, eachSteps(1), true},
                           {"frame", "vtu", &frame, eachSteps(1), false}});
    Runner runner(plan);
    std::vector<Saved> saved;
    restart.on_take = [&] {
        MemoryArchive archive;
        runner.transfer(archive);
        saved.push_back(archive.saved);
    };
    runAll(runner, go_on);
    CHECK(journal == Journal{{"frame", 0, 0, 0},
                             {"frame", 1, 1, 1},
                             {"restart", 1, 1, 1},
                             {"frame", 2, 1, 2},
                             {"restart", 2, 1, 2}});
    REQUIRE(saved.size() == 2);
    CHECK(std::get<std::int64_t>(saved[0]["outputs/frame/next"]) == 2);
    CHECK(std::get<std::int64_t>(saved[0]["outputs/frame/last_step"]) == 1);
    CHECK(std::get<std::int64_t>(saved[0]["outputs/frame/state/frames"]) == 2);
    CHECK(std::get<std::int64_t>(saved[0]["outputs/restart/next"]) == 2);
    CHECK(std::get<std::int64_t>(saved[0]["outputs/restart/last_step"]) == 1);
}

TEST_CASE("what outputs take is written in order, while steps go on") {
    Journal journal;
    RecordingOutput restart("restart", journal), frame("frame", journal);
    std::vector<std::string> written;
    std::atomic<bool> stepped = false;
    frame.on_write = [&] {
        // The first frame is written only when a step has been made since.
        while (!stepped) std::this_thread::yield();
        written.emplace_back("frame");
    };
    restart.on_write = [&] { written.emplace_back("restart"); };
    Acting step([&](const Clock&) { stepped = true; });
    Plan plan = planUntil(2, fixedLayer("outer", 1, {call("step", step)}),
                          {{"restart", "restart", &restart, eachSteps(2), true},
                           {"frame", "vtu", &frame, eachSteps(1), false}});
    Runner runner(plan);
    int watched = 0;
    runner.watchWrites([&] { ++watched; });
    runAll(runner, go_on);
    CHECK(written == std::vector<std::string>{"frame", "frame", "frame", "restart"});
    CHECK(watched == 5);  // and before what brings all to the disk
}

TEST_CASE("a write that fails ends the run before the next restart") {
    Journal journal;
    RecordingOutput restart("restart", journal), frame("frame", journal);
    std::atomic<bool> failed = false;
    int restarts = 0;
    frame.on_write = [&] {
        failed = true;
        throw FileError("cannot write");
    };
    restart.on_write = [&] { ++restarts; };
    // As long as it takes the other thread to fail.
    Acting step([&](const Clock&) {
        while (!failed) std::this_thread::yield();
    });
    Plan plan = planUntil(100, fixedLayer("outer", 1, {call("step", step)}),
                          {{"restart", "restart", &restart, eachSteps(50), true},
                           {"frame", "vtu", &frame, {}, false}});
    Runner runner(plan);
    CHECK_THROWS_AS(runAll(runner, go_on), FileError);
    CHECK(runner.clock().steps < 50);
    CHECK_THROWS_AS(runner.syncOutputs(), FileError);
    CHECK(restarts == 0);
}

TEST_CASE("a hook stops the run; restarts are written, other outputs are not") {
    Frames frames;
    Journal journal;
    RecordingOutput restart("restart", journal);
    Plan plan = planUntil(10, fixedLayer("outer", 1, {}),
                          {frames.entry(eachSteps(4)), {"restart", "restart", &restart, {}, true}});
    Runner runner(plan);
    const Outcome outcome = runAll(runner, [](const Clock& clock) -> std::optional<std::string> {
        if (clock.steps == 3) return "interrupted";
        return {};
    });
    CHECK_FALSE(outcome.finished);
    CHECK(outcome.reason == "interrupted");
    CHECK(runner.clock().time == 3);
    CHECK(frames.times() == std::vector<double>{0});
    CHECK(journal == Journal{{"restart", 3, 1, 3}});
    CHECK(frames.output.finished == 1);
}

TEST_CASE("a run that is stopped before its first step keeps its first state") {
    Journal journal;
    RecordingOutput restart("restart", journal), frame("frame", journal);
    Plan plan = planUntil(
        1, fixedLayer("outer", 0.5, {}),
        {{"restart", "restart", &restart, {}, true}, {"frame", "vtu", &frame, {}, false}});
    Runner runner(plan);
    const Outcome outcome = runAll(runner, go_on, "signal");
    CHECK_FALSE(outcome.finished);
    CHECK(outcome.reason == "signal");
    CHECK(journal == Journal{{"frame", 0, 0, 0}, {"restart", 0, 0, 0}});
}

TEST_CASE("a stop in the last step is a finished run") {
    Plan plan = planUntil(1, fixedLayer("outer", 1, {}));
    const Outcome outcome = runAll(Runner(plan), [](const Clock&) { return "interrupted"; });
    CHECK(outcome.finished);
    CHECK(outcome.reason.empty());
}

TEST_CASE("what a hook or a method throws passes through before anything is written") {
    Frames frames;
    Plan plan = planUntil(1, fixedLayer("outer", 1, {}), {frames.entry(eachSteps(1))});
    Runner runner(plan);
    CHECK_THROWS_AS(
        runAll(runner,
               [](const Clock&) -> std::optional<std::string> { throw PhysicsError("NaN"); }),
        PhysicsError);
    CHECK(frames.times() == std::vector<double>{0});
}

TEST_CASE("nothing to do: the end time is the start time") {
    Frames frames;
    Plan plan;
    plan.outermost = fixedLayer("outer", 1, {});
    plan.outputs = {frames.entry(eachSteps(1))};
    Runner runner(plan);
    CHECK(runAll(runner, go_on).finished);
    CHECK(frames.times() == std::vector<double>{0});
}

TEST_CASE("progress") {
    Plan plan;
    plan.start_time = 1;
    plan.end_time = 5;
    plan.outermost = fixedLayer("outer", 1, {});
    Runner runner(plan);
    CHECK(runner.progress().fraction == 0);
    CHECK(std::isnan(runner.progress().seconds_left));
    runAll(runner, [&](const Clock& clock) {
        const Progress now = runner.progress();
        CHECK(now.time == clock.time);
        CHECK(now.end_time == 5);
        CHECK(now.fraction == static_cast<double>(clock.steps) / 4);
        CHECK(now.steps == clock.steps);
        CHECK(now.dt == 1);
        CHECK(now.seconds > 0);
        CHECK(now.steps_per_second == Approx(static_cast<double>(now.steps) / now.seconds));
        CHECK(now.seconds_left == Approx(now.seconds * static_cast<double>(4 - now.steps) /
                                         static_cast<double>(now.steps)));
        return std::nullopt;
    });
    CHECK(runner.progress().fraction == 1);
    CHECK(runner.progress().seconds_left == 0);
}

TEST_CASE("calls of the start know that there is no step yet") {
    std::vector<bool> starts;
    Acting act([&](const Clock& clock) { starts.push_back(clock.is_start); });
    Plan plan;
    plan.end_time = 2;
    plan.start = {acting("act", act)};
    plan.outermost = fixedLayer("outer", 1, {call("act", act)});
    runAll(Runner(plan), go_on);
    CHECK(starts == std::vector<bool>{true, false, false});
}

TEST_CASE("plans that cannot run are refused") {
    Journal journal;
    Recorder method("method", journal);
    RecordingOutput output("output", journal);
    Plan plan = planUntil(1, fixedLayer("outer", 1, {call("method", method)}));
    const auto message = [&]() -> std::string {
        try {
            validate(plan);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message().empty());

    SECTION("no dt") {
        plan.outermost.fixed_dt.reset();
        CHECK(message() == "loop: layer outer has no dt");
    }
    SECTION("a dt that is not above 0") {
        plan.outermost.fixed_dt = 0;
        CHECK(message() == "loop: layer outer: dt must be above 0");
    }
    SECTION("equal names") {
        plan.outermost.steps.push_back({fixedLayer("outer", 1, {})});
        CHECK(message() == "loop: two layers are called outer");
    }
    SECTION("no method") {
        plan.start = {Call{{"lists"}, nullptr, runOf}};
        CHECK(message() == "loop: lists has no method");
    }
    SECTION("a start call under every") {
        plan.start = {acting("lists", method, eachSteps(2))};
        CHECK(message() == "loop: lists: a start call runs once");
        plan.start = {acting("lists", method, {}, {{}, 1.0})};
        CHECK(message() == "loop: lists: a start call runs once");
    }
    SECTION("a window without an inside") {
        plan.outermost.steps.push_back({acting("lists", method, {}, {1.0, 1.0})});
        CHECK(message() == "loop: lists: the end of its time must be above the start");
    }
    SECTION("steps that are no whole number") {
        plan.outputs = {{"frames", "vtu", &output, Trigger{Trigger::Kind::steps, 1.5, ""}, false}};
        CHECK(message() == "loop: output frames: steps must be a whole number");
    }
    SECTION("an unknown layer") {
        plan.outputs = {{"frames", "vtu", &output, eachSteps(1, "acustic"), false}};
        CHECK(message() == "loop: output frames: no layer acustic to count steps of");
    }
    SECTION("a call by wall time") {
        plan.outermost.steps = {every("sort", method, {Trigger::Kind::wall_time, 1, ""})};
        CHECK(message() == "loop: sort: a call cannot depend on the wall time");
    }
    SECTION("overshoot in a layer that splits") {
        plan.outermost.steps = {
            {fixedLayer("middle", 1, {{fixedLayer("inner", 1, {}, Fit::overshoot)}})}};
        CHECK(message() == "loop: layer inner overshoots where its parent cannot follow");
    }
    SECTION("overshoot after another inner layer") {
        plan.outermost.steps = {{fixedLayer("first", 1, {})},
                                {fixedLayer("second", 1, {}, Fit::overshoot)}};
        CHECK(message() == "loop: layer second overshoots where its parent cannot follow");
    }
    SECTION("two outputs of one name") {
        plan.outputs = {{"frames", "vtu", &output, {}, false},
                        {"frames", "vtu", &output, {}, false}};
        CHECK(message() == "loop: two outputs are called frames");
    }
}
