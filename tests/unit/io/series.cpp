// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/series.h"

#include "../memory_archive.h"
#include "core/errors.h"
#include "core/types.h"
#include "io/hdf5/reader.h"
#include "support.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

class Probe final : public SeriesSource {
 public:
    explicit Probe(std::vector<SeriesQuantity> quantities) : quantities_(std::move(quantities)) {}
    const std::vector<SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override {
        for (std::size_t k = 0; k < row.size(); ++k)
            row[k] = clock.time / 3 + static_cast<double>(k);
        if (clock.steps == 1) row[0] = nan_value;
    }

 private:
    std::vector<SeriesQuantity> quantities_;
};

const std::vector<SeriesQuantity> quantities{
    {"pressure", "Pa", "pressure at the probe", {}},
    {"velocity", "m/s", "velocity at the probe", {"x", "y"}},
    {"count, \"all\"", "", "neighbors", {}}};

const std::string header =
    "time [s],pressure [Pa],velocity_x [m/s],velocity_y [m/s],\"count, \"\"all\"\"\"\n";

Clock clockOf(int step) {
    Clock clock;
    clock.time = 0.1 * step;
    clock.steps = step;
    return clock;
}

struct Run {
    std::shared_ptr<ResultsFile> file;
    SeriesOutput output;

    explicit Run(const TemporaryFolder& folder,
                 const std::vector<SeriesQuantity>& list = quantities)
        : file(std::make_shared<ResultsFile>(folder / "results.h5", Provenance{})),
          output({folder.path(), "probe", "s", true, file}, std::make_unique<Probe>(list)) {}
    void write(int begin, int end) {
        for (int step = begin; step < end; ++step) output.write(clockOf(step));
    }
};

std::string csv(const TemporaryFolder& folder) { return readFile(folder / "probe.csv", 1 << 20); }

}  // namespace

TEST_CASE("rows of a series read back exactly") {
    TemporaryFolder folder;
    Run(folder).write(0, 4);
    CHECK(csv(folder) == header +
                             "0,0,1,2,3\n"
                             "0.1,nan,1.0333333333333334,2.033333333333333,3.033333333333333\n"
                             "0.2,0.06666666666666667,1.0666666666666667,2.066666666666667,"
                             "3.066666666666667\n"
                             "0.30000000000000004,0.10000000000000002,1.1,2.1,3.1\n");
    const hdf5::Reader reader(folder / "results.h5");
    CHECK(reader.numbers("series/probe/time") ==
          std::vector<double>{0, 0.1, 0.2, 0.30000000000000004});
    CHECK(reader.numbers("series/probe/velocity") ==
          std::vector<double>{1, 2, 0.1 / 3 + 1, 0.1 / 3 + 2, 0.2 / 3 + 1, 0.2 / 3 + 2,
                              clockOf(3).time / 3 + 1, clockOf(3).time / 3 + 2});
}

TEST_CASE("a resumed series drops later rows and goes on") {
    // More rows than a chunk of the HDF5 dataset holds; resumed inside and at the edge of one.
    const int resumed = GENERATE(0, 5, 1023, 1024, 1025, 2000);
    TemporaryFolder whole, parts;
    Run(whole).write(0, 2200);
    Run(parts).write(0, 2100);
    const std::string before = csv(parts);
    File::openAppend(parts / "probe.csv").write("210.0,1.2");  // cut short by a crash
    Run second(parts);
    second.output.resume(clockOf(resumed));
    CHECK(before.starts_with(csv(parts)));
    second.write(resumed + 1, 2200);
    CHECK(csv(parts) == csv(whole));
    const hdf5::Reader a(whole / "results.h5"), b(parts / "results.h5");
    for (const std::string name : {"time", "velocity", "count, \"all\""})
        CHECK(a.numbers("series/probe/" + name) == b.numbers("series/probe/" + name));
}

TEST_CASE("rows that are missing before the restart are told") {
    TemporaryFolder folder;
    Run first(folder);
    first.write(0, 4);
    MemoryArchive archive;
    first.output.transfer(archive);
    archive.is_loading = true;
    const std::string whole = csv(folder);
    const auto resume = [&](const std::string& text) {
        File::create(folder / "probe.csv").write(text);
        Run again(folder);
        again.output.transfer(archive);
        again.output.resume(clockOf(3));
    };
    CHECK_NOTHROW(resume(whole));
    CHECK_THROWS_WITH(
        resume(whole.substr(0, whole.rfind("0.2,"))),
        Catch::Contains("probe.csv has 2 rows up to time 0.3") && Catch::Contains("had written 4"));
}

TEST_CASE("a series with other quantities is kept beside the new one") {
    TemporaryFolder folder;
    Run(folder).write(0, 3);
    Run second(folder, {{"density", "", "", {}}});
    second.output.resume(clockOf(2));
    second.write(3, 4);
    CHECK(csv(folder) == "time [s],density\n0.30000000000000004,0.10000000000000002\n");
    CHECK(readFile(folder / "probe.before_2.csv", 10000).starts_with(header));
    const hdf5::Reader reader(folder / "results.h5");
    CHECK(reader.numbers("series/probe/density").size() == 1);
    CHECK(reader.numbers("series/probe.before_2/pressure").size() == 3);
}

TEST_CASE("a CSV file is not overwritten, a half-written one is begun again") {
    TemporaryFolder folder;
    File::create(folder / "probe.csv").write(header.substr(0, 10));
    CHECK_THROWS_WITH(Run(folder).write(0, 1), Catch::Contains("it exists already"));
    Run run(folder);
    run.output.resume(clockOf(0));
    run.write(1, 2);
    CHECK(csv(folder).starts_with(header + "0.1,nan"));
    File::create(folder / "probe.csv").write(header + "0,1,2,3,4\nx,1,2,3,4\n");
    CHECK_THROWS_WITH(run.output.resume(clockOf(5)),
                      Catch::Contains("\"x,1,2,3,4\" is not a row that sphinx wrote"));
}
