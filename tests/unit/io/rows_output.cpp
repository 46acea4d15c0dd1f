// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/rows_output.h"

#include "../memory_archive.h"
#include "../scene/outputs.h"
#include "support.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

/// Two values that the test sets.
struct Given : SeriesSource {
    std::vector<SeriesQuantity> columns{{"a", "", "", {}}, {"b", "", "", {}}};
    const std::vector<double>* values;
    explicit Given(const std::vector<double>& v) : values(&v) {}
    const std::vector<SeriesQuantity>& quantities() const override { return columns; }
    void sample(const Clock&, std::span<double> row) override {
        std::copy(values->begin(), values->end(), row.begin());
    }
};

struct Rows {
    TemporaryFolder folder;
    std::vector<double> values{0, 0};

    std::unique_ptr<RowsOutput> make(bool average, const std::string& form = "given",
                                     const std::string& layer = "") {
        SeriesParameters series;
        series.folder = folder.path();
        series.name = "row";
        RowsParameters parameters;
        parameters.mean.average = average;
        parameters.mean.layer.text = layer;
        parameters.form = form;
        return std::make_unique<RowsOutput>(series, parameters, std::make_unique<Given>(values));
    }
    void sample(Output& output, double dt, std::vector<double> now) {
        values = std::move(now);
        output.sample(clockAt(0, dt));
    }
    std::string text() const { return readFile(folder / "row.csv", 10000); }
};

}  // namespace

TEST_CASE("without averages a row holds the values of its instant") {
    Rows rows;
    const auto output = rows.make(false);
    CHECK_FALSE(output->sampledLayer());
    rows.values = {1, 2};
    output->write(clockAt(0));
    rows.values = {3, nan_value};
    output->write(clockAt(0.5));
    CHECK(rows.text() == "time,a,b\n0,1,2\n0.5,3,nan\n");
}

TEST_CASE("rows are means over time since the row before, without what is NaN") {
    Rows rows;
    const auto output = rows.make(true);
    CHECK(output->sampledLayer() == "");
    rows.values = {8, nan_value};
    output->write(clockAt(0));  // before any step: the values themselves
    rows.sample(*output, 1, {1, nan_value});
    rows.sample(*output, 3, {2, 5});
    output->write(clockAt(4));
    rows.sample(*output, 0.5, {6, nan_value});
    output->write(clockAt(4.5));
    CHECK(rows.text() == "time,a,b\n0,8,nan\n4,1.75,5\n4.5,6,nan\n");
}

TEST_CASE("means over the steps of a layer ask for that layer") {
    Rows rows;
    CHECK(rows.make(true, "given", "acoustic")->sampledLayer() == "acoustic");
    CHECK_FALSE(rows.make(false)->sampledLayer());
}

TEST_CASE("a mean goes on after a restart with the same bits") {
    Rows rows;
    Rows again;
    MemoryArchive archive;
    const std::string layer = GENERATE("", "acoustic");
    const auto whole = rows.make(true, "given", layer);
    rows.sample(*whole, 0.1, {1.0 / 3, 7});
    rows.sample(*whole, 0.3, {2.0 / 7, nan_value});
    whole->transfer(archive);
    const auto resumed = again.make(true, "given", layer);
    archive.is_loading = true;
    resumed->transfer(archive);
    resumed->resume(clockAt(0.4));
    for (const auto& [run, output] : {std::pair(&rows, whole.get()), {&again, resumed.get()}}) {
        run->sample(*output, 0.7, {1.0 / 11, 3});
        output->write(clockAt(1.1));
    }
    CHECK(rows.text() == again.text());

    SECTION("unless it means something else now") {
        for (const auto& other : {again.make(false), again.make(true, "changed"),
                                  again.make(true, "given", layer.empty() ? "acoustic" : "")}) {
            other->transfer(archive);
            again.values = {4, 4};
            Clock clock = clockAt(1.1);
            other->resume(clock);
            other->write(clockAt(2));
            CHECK_THAT(again.text(), Catch::EndsWith("\n2,4,4\n"));
        }
    }
}
