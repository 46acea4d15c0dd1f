// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "fakes.h"
#include "loop/run/runner.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

/// A run with state: three layers whose steps depend on a number that the calls change, calls
/// under triggers of every kind, outputs of every kind.
struct Run {
    double state = 0.3;
    Journal calls;   // what acts on the physics
    Journal frames;  // what is written
    Acting kick{[this](const Clock& c) {
        state = std::fmod(state * 1.7 + c.dt, 1.0);
        calls.push_back({"kick", c.time, c.dt, c.steps});
    }};
    Recorder start{"start", calls}, sort{"sort", calls}, remesh{"remesh", calls};
    Estimate large{[this] { return 0.11 + 0.1 * state; }};
    Estimate middle{[this] { return 0.031 + 0.02 * state; }};
    Estimate small{[this] { return 0.007 + 0.005 * state; }};
    RecordingOutput fields{"fields", frames}, probe{"probe", frames}, restart{"restart", frames};
    Trigger fields_trigger = eachTime(0.25);

    std::unique_ptr<Runner> runner;
    struct Checkpoint {
        double state = 0;
        Saved saved;
        std::int64_t step = 0;
    };
    std::vector<Checkpoint> checkpoints;

    Checkpoint checkpoint() {
        MemoryArchive archive;
        runner->transfer(archive);
        return {state, archive.saved, runner->clock().steps};
    }

    void build(double end_time) {
        Layer inner{"inner",
                    {{{"small"}, &small}},
                    {},
                    Fit::clip,
                    {call("kick", kick),
                     every("remesh", remesh, eachSteps(7, "inner")),
                     {acting("extra kick", kick, {}, {0.7, 2.2})},
                     {acting("remesh late", remesh, eachTime(0.05), {1.1, {}})}}};
        Layer middle_layer{"middle",
                           {{{"middle"}, &middle}},
                           {},
                           Fit::split,
                           {{inner}, every("remesh", remesh, eachTime(0.1))}};
        Plan plan;
        plan.end_time = end_time;
        plan.start = {acting("start", start)};
        plan.outermost = {"outer",
                          {{{"large"}, &large}},
                          {},
                          Fit::split,
                          {{middle_layer}, every("sort", sort, eachSteps(3))}};
        plan.outputs = {{"restart", "restart", &restart, eachSteps(4), true},
                        {"fields", "vtu", &fields, fields_trigger, false},
                        {"probe", "observe", &probe, eachSteps(5, "middle"), false}};
        runner = std::make_unique<Runner>(plan);
        restart.on_take = [this] { checkpoints.push_back(checkpoint()); };
    }

    void load(const Checkpoint& from) {
        state = from.state;
        MemoryArchive archive(from.saved);
        runner->transfer(archive);
    }

    Outcome go(std::int64_t stop_at = -1) {
        return runAll(*runner, [=](const Clock& clock) -> std::optional<std::string> {
            if (clock.steps == stop_at) return "stop";
            return {};
        });
    }
};

/// The part of a journal after so many steps; `entry` is the time there.
Journal after(const Journal& journal, double time) {
    Journal rest;
    for (const Event& event : journal)
        if (event.time >= time) rest.push_back(event);
    return rest;
}

Journal joined(Journal first, const Journal& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Journal without(const Journal& journal, const std::string& prefix) {
    Journal rest;
    for (const Event& event : journal)
        if (event.name.rfind(prefix, 0) != 0) rest.push_back(event);
    return rest;
}

}  // namespace

TEST_CASE("a run resumed from each of its restarts goes on as if nothing had happened") {
    Run whole;
    whole.build(3);
    CHECK(whole.go().finished);
    REQUIRE(whole.checkpoints.size() >= 4);

    for (const Run::Checkpoint& from : whole.checkpoints) {
        Run rest;
        rest.build(3);
        rest.load(from);
        CHECK(rest.runner->resumed());
        const double time = rest.runner->clock().time;
        CHECK(rest.go().finished);
        // Same calls, clocks and numbers, bitwise; start is not run again.
        CHECK(rest.calls == after(whole.calls, time));
        CHECK(rest.state == whole.state);
        CHECK(rest.runner->clock().time == whole.runner->clock().time);
        CHECK(rest.runner->clock().steps == whole.runner->clock().steps);
        // Each output is told where it goes on; then the frames that the run had not written.
        REQUIRE(rest.frames.size() >= 3);
        CHECK(rest.frames[0] == Event{"resume restart", time, rest.frames[0].dt, from.step});
        CHECK(rest.frames[1].name == "resume fields");
        CHECK(rest.frames[2].name == "resume probe");
        Journal missing;
        for (const Event& event : whole.frames)
            if (event.steps > from.step) missing.push_back(event);
        CHECK(without(rest.frames, "resume") == missing);
        CHECK(rest.fields.frames() == whole.fields.frames());
    }
}

TEST_CASE("a run stopped anywhere and resumed writes the same frames") {
    Run whole;
    whole.build(3);
    whole.go();
    for (std::int64_t stop = 1; stop < whole.runner->clock().steps; ++stop) {
        Run first;
        first.build(3);
        CHECK_FALSE(first.go(stop).finished);
        REQUIRE(first.checkpoints.back().step == stop);
        Run second;
        second.build(3);
        second.load(first.checkpoints.back());
        second.go();
        CHECK(joined(first.calls, second.calls) == whole.calls);
        const Journal frames = joined(first.frames, without(second.frames, "resume"));
        // A stop writes one more restart, nothing else.
        CHECK(without(frames, "restart") == without(whole.frames, "restart"));
    }
}

TEST_CASE("a finished run continues with a later end time as if it had never ended") {
    Run whole;
    whole.build(3);
    whole.go();

    Run first;
    first.build(1.3);
    CHECK(first.go().finished);
    const Run::Checkpoint end = first.checkpoints.back();
    CHECK(end.step == first.runner->clock().steps);
    Run second;
    second.build(3);
    second.load(end);
    CHECK(second.go().finished);

    CHECK(joined(first.calls, second.calls) == whole.calls);
    CHECK(second.state == whole.state);
    // The frames of the former end are extra, all others the same.
    Journal frames = without(joined(first.frames, without(second.frames, "resume")), "restart");
    const Journal expected = without(whole.frames, "restart");
    const double former_end = first.runner->clock().time;
    std::erase_if(frames, [&](const Event& event) {
        return event.time == former_end &&
               std::find(expected.begin(), expected.end(), event) == expected.end();
    });
    CHECK(frames == expected);
}

TEST_CASE("a finished run that is resumed unchanged writes nothing") {
    Run first;
    first.build(1);
    first.go();
    Run again;
    again.build(1);
    again.load(first.checkpoints.back());
    CHECK(again.go().finished);
    CHECK(again.calls.empty());
    CHECK(without(again.frames, "resume").empty());
    CHECK(again.fields.finished == 1);

    // In another folder it leaves the state it came with.
    Run elsewhere;
    elsewhere.build(1);
    elsewhere.load(first.checkpoints.back());
    elsewhere.runner->leaveFolder();
    elsewhere.go();
    const Journal written = without(elsewhere.frames, "resume");
    REQUIRE(written.size() == 1);
    CHECK(written[0].name == "restart");
    CHECK(elsewhere.checkpoints.back().state == first.checkpoints.back().state);
    CHECK(elsewhere.checkpoints.back().step == first.checkpoints.back().step);
}

TEST_CASE("outputs may change between a run and its resumption") {
    // So long that the steps after the resumption reach no multiple at once.
    Run first, whole, second;
    for (Run* run : {&first, &whole, &second}) run->fields_trigger = eachTime(0.7);
    first.build(1);
    first.go();
    Run::Checkpoint from = first.checkpoints.back();

    SECTION("a new output writes from the next multiple on") {
        for (const char* name : {"type", "every", "next", "last_step", "state/frames"})
            from.saved.erase(std::string("outputs/fields/") + name);
        from.saved["outputs/names"] = std::string("restart\nprobe\n");
    }
    SECTION("a changed trigger goes on from the present time") {
        from.saved["outputs/fields/every"] = std::string("time 0.001");
        from.saved["outputs/fields/next"] = std::int64_t{1001};
        from.saved["outputs/fields/last_step"] = std::int64_t{-1};
    }
    SECTION("another type under the same name") {
        from.saved["outputs/fields/type"] = std::string("hdf5");
        from.saved["outputs/fields/state/frames"] = std::int64_t{77};
        from.saved["outputs/fields/last_step"] = std::int64_t{-1};
    }
    whole.build(2);
    whole.go();
    second.build(2);
    second.load(from);
    second.go();
    Journal fields, expected;
    for (const Event& event : second.frames)
        if (event.name == "fields") fields.push_back(event);
    for (const Event& event : whole.frames)
        if (event.name == "fields" && event.steps > from.step) expected.push_back(event);
    CHECK(fields == expected);
}

TEST_CASE("a restart of another loop does not load") {
    Run first;
    first.build(1);
    first.go();
    Plan plan = planUntil(1, fixedLayer("advection", 1, {}));
    Runner runner(plan);
    MemoryArchive archive(first.checkpoints.back().saved);
    CHECK_THROWS_AS(runner.transfer(archive), FileError);
}
