// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/window.h"
#include "fakes.h"
#include "loop/run/layer_run.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::loop;
using namespace sphinx::loop::fake;

namespace {

Step limited(std::string label, dynamics::Method& method, std::optional<double> from,
             std::optional<double> until, std::optional<Trigger> trigger = {}) {
    return {acting(std::move(label), method, std::move(trigger), {from, until})};
}

/// Numbers of the substeps in which the method of that name acted.
std::vector<std::int64_t> stepsOf(const Journal& journal, const std::string& name) {
    std::vector<std::int64_t> steps;
    for (const Event& event : journal)
        if (event.name == name) steps.push_back(event.steps);
    return steps;
}

using Numbers = std::vector<std::int64_t>;

}  // namespace

TEST_CASE("the text of a window") {
    CHECK(describe(Window{}, " ms") == "");
    CHECK(describe(Window{0.4, {}}, "") == "from 0.4");
    CHECK(describe(Window{{}, 0.5}, " ms") == "until 0.5 ms");
    CHECK(describe(Window{0.4, 0.5}, " ms") == "from 0.4 ms until 0.5 ms");
}

TEST_CASE("a call acts in the substeps that begin within its window") {
    Journal journal;
    Recorder early("early", journal), mid("mid", journal), late("late", journal);
    // Ten times 0.1 is a little less than 1, three times a little more than 0.3.
    const Layer outer = fixedLayer("outer", 0.1,
                                   {limited("early", early, {}, 0.3), limited("mid", mid, 0.3, 0.8),
                                    limited("late", late, 0.8, {})});
    LayerRun run(outer, 0);
    for (int k = 0; k < 10; ++k) run.stepFreely();
    CHECK(stepsOf(journal, "early") == Numbers{0, 1, 2});
    CHECK(stepsOf(journal, "mid") == Numbers{3, 4, 5, 6, 7});
    CHECK(stepsOf(journal, "late") == Numbers{8, 9});
}

TEST_CASE("a call of an inner layer goes by the substeps of that layer") {
    Journal journal;
    Recorder before("before", journal), after("after", journal), outside("outside", journal);
    const Layer inner = fixedLayer(
        "inner", 0.25, {limited("before", before, {}, 1.6), limited("after", after, 1.6, {})});
    const Layer outer = fixedLayer("outer", 1.0, {{inner}, limited("outside", outside, 1.6, {})});
    LayerRun run(outer, 0);
    for (int k = 0; k < 3; ++k) run.stepFreely();
    CHECK(stepsOf(journal, "before") == Numbers{0, 1, 2, 3, 4, 5, 6});
    CHECK(stepsOf(journal, "after") == Numbers{7, 8, 9, 10, 11});
    CHECK(stepsOf(journal, "outside") == Numbers{2});
}

TEST_CASE("two calls that share the time act once each substep, whatever the steps") {
    Journal journal;
    Recorder first("first", journal), second("second", journal);
    double wobble = 0;
    Estimate irregular([&] { return 0.0137 * (1.1 + std::sin(wobble += 0.7)); });
    const Layer inner{"inner",
                      {{{"dt"}, &irregular}},
                      {},
                      Fit::split,
                      {limited("first", first, {}, 1.0), limited("second", second, 1.0, {}),
                       limited("first", first, {}, 1.0), limited("second", second, 1.0, {})}};
    const Layer outer = fixedLayer("outer", 0.04, {{inner}});
    LayerRun run(outer, 0);
    for (int k = 0; k < 50; ++k) run.stepFreely();
    const auto steps = static_cast<std::size_t>(run.find("inner")->clock().steps);
    REQUIRE(journal.size() == 2 * steps);
    for (std::size_t k = 0; k < journal.size(); ++k) {
        CHECK(journal[k].steps == static_cast<std::int64_t>(k / 2));
        CHECK(journal[k].name == journal[k - k % 2].name);
    }
    CHECK(journal.front().name == "first");
    CHECK(journal.back().name == "second");
}

TEST_CASE("a step whose size changes on the way keeps to what it has begun with") {
    Journal journal;
    Recorder first("first", journal), second("second", journal);
    const Layer inner = fixedLayer("inner", 0.75, {}, Fit::overshoot);
    const Layer outer =
        fixedLayer("outer", 1.0,
                   {limited("first", first, {}, 1.0), {inner}, limited("second", second, 1.0, {})});
    LayerRun run(outer, 0);
    run.stepFreely();  // to 1.5
    CHECK(run.clock().time == 1.5);
    run.stepFreely();
    CHECK(stepsOf(journal, "first") == Numbers{0});
    CHECK(stepsOf(journal, "second") == Numbers{1});
}

TEST_CASE("moments of every outside of the window pass") {
    Journal journal;
    Recorder act("act", journal);
    const Trigger trigger = GENERATE(eachSteps(3), eachTime(0.75));
    const Layer outer = fixedLayer("outer", 0.25, {limited("act", act, 1.0, 2.75, trigger)});
    LayerRun run(outer, 0);
    for (int k = 0; k < 16; ++k) run.stepFreely();
    // Due in steps 2, 5, 8, 11, 14; the window holds 4 to 10.
    CHECK(stepsOf(journal, "act") == Numbers{5, 8});
}

namespace {

/// Writes down when it rests.
class Resting : public Recorder {
 public:
    Resting(std::string name, Journal& journal)
        : Recorder(name, journal), name_(std::move(name)), journal_(journal) {}
    void rest() override { journal_.push_back({name_ + " rests", 0, 0, 0}); }

 private:
    std::string name_;
    Journal& journal_;
};

std::vector<std::string> namesOf(const Journal& journal) {
    std::vector<std::string> names;
    for (const Event& event : journal) names.push_back(event.name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a method rests once, at the begin of the first step after its window") {
    Journal journal;
    Resting mid("mid", journal), other("other", journal), never("never", journal);
    Recorder first("first", journal);
    const Layer outer = fixedLayer("outer", 0.25,
                                   {{acting("first", first)},
                                    limited("mid", mid, 0.25, 0.75),
                                    limited("other", other, 0.5, {}),
                                    limited("never", never, 0.1, 0.2)});
    LayerRun run(outer, 0);
    for (int k = 0; k < 5; ++k) run.stepFreely();
    CHECK(namesOf(journal) == Names{"first", "first", "mid", "first", "mid", "other", "mid rests",
                                    "first", "other", "first", "other"});
}

TEST_CASE("a method that goes on in another window rests before it acts again") {
    Journal journal;
    Resting act("act", journal);
    // In either order: the line that ends does not take back what the other one does.
    const bool swapped = GENERATE(false, true);
    std::vector<Step> lines{limited("act", act, {}, 0.5), limited("act", act, 0.5, {})};
    if (swapped) std::swap(lines[0], lines[1]);
    const Layer outer = fixedLayer("outer", 0.25, std::move(lines));
    LayerRun run(outer, 0);
    for (int k = 0; k < 4; ++k) run.stepFreely();
    CHECK(namesOf(journal) == Names{"act", "act", "act rests", "act", "act"});
}

TEST_CASE("a resumed run knows whose window is under way") {
    const auto events = [](int steps_before) {
        Journal journal;
        Resting act("act", journal);
        const Layer inner = fixedLayer("inner", 0.25, {limited("act", act, {}, 0.75)});
        const Layer outer = fixedLayer("outer", 0.25, {{inner}});
        MemoryArchive saved;
        {
            LayerRun run(outer, 0);
            for (int k = 0; k < steps_before; ++k) run.stepFreely();
            run.transfer(saved);
        }
        MemoryArchive loaded(saved.saved);
        LayerRun run(outer, 0);
        run.transfer(loaded);
        for (int k = steps_before; k < 5; ++k) run.stepFreely();
        return namesOf(journal);
    };
    for (const int steps_before : {0, 1, 2, 3, 4})
        CHECK(events(steps_before) == Names{"act", "act", "act", "act rests"});
}
