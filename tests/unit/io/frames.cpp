// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/errors.h"
#include "core/writer.h"
#include "io/frames/hdf5.h"
#include "io/frames/tecplot.h"
#include "io/frames/vtkhdf.h"
#include "io/frames/vtu.h"
#include "io/hdf5/reader.h"
#include "io/restart/output.h"
#include "support.h"

#include <catch2/catch.hpp>
#include <map>

// What other readers find in the files is tested in tests/regression/readers.

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

Clock clockOf(int frame) {
    Clock clock;
    clock.time = 0.5 * frame;
    clock.steps = 10 * frame;
    return clock;
}

void writeFrames(Output& output, bodies::Body<2>& body, int begin, int end) {
    for (int frame = begin; frame < end; ++frame) {
        setValues(body, frame);
        output.write(clockOf(frame));
    }
}

/// Writes frames and returns the state that a restart after `saved` of them holds.
SavedState writeFramesFrom(Output& output, bodies::Body<2>& body, int saved, int end) {
    writeFrames(output, body, 0, saved);
    const SavedState state(output);
    writeFrames(output, body, saved, end);
    output.finish();
    return state;
}

std::vector<std::string> names(const Path& folder) {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace

TEST_CASE("what is taken is written, whatever the particles do meanwhile") {
    auto body = makeBody<2>("water", 30);
    const std::vector<BodyFrames<2>> frames{{body.get(), {"velocity", "pressure", "strain"}}};
    // Each with the bytes of all its files.
    const auto contents = [&](const Path& folder, const auto& write) {
        const auto results = std::make_shared<ResultsFile>(folder / "results.h5", Provenance{});
        const FrameParameters parameters{folder, false, {}, {}};
        RestartParameters restart;
        restart.folder = folder / "restart";
        restart.header.case_name = "tank";
        std::vector<std::unique_ptr<Output>> outputs;
        outputs.push_back(std::make_unique<VtuOutput<2>>(parameters, frames));
        outputs.push_back(std::make_unique<VtkHdfOutput<2>>(parameters, frames));
        outputs.push_back(std::make_unique<TecplotOutput<2>>(parameters, frames));
        outputs.push_back(std::make_unique<Hdf5Output<2>>(Hdf5Parameters{}, results, frames));
        outputs.push_back(std::make_unique<RestartOutput<2>>(
            restart,
            std::vector<RestartBody<2>>{{body.get(), {"velocity", "pressure", "mass", "strain"}}},
            [&](Archive& archive) {
                for (std::size_t k = 0; k < 4; ++k) {
                    const Section section(archive, std::to_string(k));
                    outputs[k]->transfer(archive);
                }
            }));
        write(outputs);
        std::map<std::string, std::string> bytes;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.is_regular_file())
                bytes[entry.path().filename()] = readFile(entry.path(), 10'000'000);
        return bytes;
    };
    const TemporaryFolder in_line, later;
    const auto expected = contents(in_line.path(), [&](const auto& outputs) {
        for (int frame = 0; frame < 4; ++frame) {
            setValues(*body, frame / 2);  // also frames in which nothing has changed
            for (const auto& output : outputs) output->write(clockOf(frame));
        }
    });
    const auto found = contents(later.path(), [&](const auto& outputs) {
        std::vector<FileWork> works;
        for (int frame = 0; frame < 4; ++frame) {
            setValues(*body, frame / 2);
            for (const auto& output : outputs) works.push_back(output->take(clockOf(frame)));
        }
        setValues(*body, 100);
        Writer writer;
        for (const FileWork& work : works) writer.add(work.write, work.bytes);
        writer.finish();
    });
    CHECK(expected.size() == 11);
    CHECK(found == expected);
}

TEST_CASE("names of frames") {
    CHECK(frameName("water", 12, ".vtu") == "water_000012.vtu");
    CHECK(frameName("water", 12345678, ".vtu") == "water_12345678.vtu");
    CHECK(frameNumber("water_000012.vtu", "water", ".vtu") == 12);
    CHECK(frameNumber("water_12345678.vtu", "water", ".vtu") == 12345678);
    for (const char* other : {"water_000012.pvd", "waters_000012.vtu", "water_top_000012.vtu",
                              "water_-00012.vtu", "water_12.vtu", "water_99999999999999999999.vtu"})
        CHECK(frameNumber(other, "water", ".vtu") == -1);
}

TEST_CASE("a frame has id and mass, the named fields once, and no others") {
    auto body = makeBody<2>("water", 2);
    const auto list = frameFields<2>({body.get(), {"pressure", "id", "position", "pressure"}});
    REQUIRE(list.size() == 3);
    CHECK(list[0]->info().name == "id");
    CHECK(list[1]->info().name == "mass");
    CHECK(list[2]->info().name == "pressure");
    CHECK_THROWS_WITH(frameFields<2>({body.get(), {"presure"}}),
                      "body 'water' has no field 'presure'");
}

TEST_CASE("outputs of frames say what they write, and how much") {
    auto body = makeBody<2>("water", 100);
    const std::vector<BodyFrames<2>> frames{{body.get(), {"velocity"}}};
    const double numbers = 100 * (2 + 1 + 1 + 2);             // position, id, mass, velocity
    const double single = 100 * (8 * (2 + 1) + 4 * (1 + 2));  // places keep their digits
    const auto check = [&](const Output& output, const std::string& name, double bytes) {
        const std::vector<OutputFile> files = output.files();
        REQUIRE(files.size() == 1);
        CHECK(files[0].name == name);
        CHECK(files[0].bytes == bytes);
    };
    const auto results = std::make_shared<ResultsFile>("results.h5", Provenance{});
    check(VtuOutput<2>({{}, false, {}, {}}, frames), "water_*.vtu", 8 * numbers);
    check(VtuOutput<2>({{}, true, {}, {}}, frames), "water_*.vtu", single);
    check(VtkHdfOutput<2>({{}, false, {}, {}}, frames), "water.vtkhdf", 8 * numbers);
    check(Hdf5Output<2>({true, {}}, results, frames), "results.h5:bodies/water", single);
    check(TecplotOutput<2>({{}, false, {}, {}}, frames), "water_*.dat", 20 * numbers);
}

TEST_CASE("VTU frames behind the resumed state are dropped, and numbers go on") {
    TemporaryFolder folder;
    auto body = makeBody<2>("water", 5);
    const FrameParameters parameters{folder.path(), false, {}, {}};
    VtuOutput<2> first(parameters, {{body.get(), {}}});
    const SavedState saved = writeFramesFrom(first, *body, 2, 5);
    File::create(folder / "water_000005.vtu.tmp").write("unfinished");
    File::create(folder / "water_level_000004.vtu").write("of another body");

    VtuOutput<2> second(parameters, {{body.get(), {}}});
    saved.restore(second);
    second.resume(clockOf(1));
    CHECK(names(folder.path()) == std::vector<std::string>{"water.pvd", "water_000000.vtu",
                                                           "water_000001.vtu",
                                                           "water_level_000004.vtu"});
    writeFrames(second, *body, 2, 3);
    const std::vector<PvdEntry> entries = readPvd(folder / "water.pvd");
    REQUIRE(entries.size() == 3);
    CHECK(entries[2].file == "water_000002.vtu");
    CHECK(entries[2].frame == 2);
    CHECK(entries[2].time == 1.0);
}

TEST_CASE("a list of VTU frames that is not ours is an error") {
    TemporaryFolder folder;
    CHECK(readPvd(folder / "none.pvd").empty());
    File::create(folder / "a.pvd").write("<svg/>");
    CHECK_THROWS_WITH(readPvd(folder / "a.pvd"),
                      Catch::Contains("it is not a ParaView collection"));
    File::create(folder / "b.pvd")
        .write(
            "<VTKFile><Collection><DataSet timestep=\"x\" frame=\"1\" file=\"f\"/>"
            "</Collection></VTKFile>");
    CHECK_THROWS_WITH(readPvd(folder / "b.pvd"), Catch::Contains("line 1 is not a frame"));
}

TEST_CASE("Tecplot frames behind the resumed state are dropped") {
    TemporaryFolder folder;
    auto body = makeBody<2>("water", 5);
    auto empty = makeBody<2>("air", 0);
    const FrameParameters parameters{folder.path(), false, {}, {{{"commit", "a\"b"}}}};
    TecplotOutput<2> first(parameters, {{body.get(), {}}, {empty.get(), {}}});
    const SavedState saved = writeFramesFrom(first, *body, 1, 3);
    TecplotOutput<2> second(parameters, {{body.get(), {}}});
    saved.restore(second);
    second.resume(clockOf(1));
    CHECK(names(folder.path()) == std::vector<std::string>{"water_000000.dat"});
    const std::string text = readFile(folder / "water_000000.dat", 10000);
    CHECK(text ==
          "TITLE = \"water\"\n"
          "VARIABLES = \"x [m]\" \"y [m]\" \"id\" \"mass [kg]\"\n"
          "DATASETAUXDATA commit = \"a'b\"\n"
          "ZONE T = \"water\", I = 5, DATAPACKING = POINT, STRANDID = 1, SOLUTIONTIME = 0\n"
          "0 1 0 0.5\n"
          "0.14285714285714285 1.1428571428571428 1 0.5\n"
          "0.2857142857142857 1.2857142857142856 2 0.5\n"
          "0.42857142857142855 1.4285714285714286 3 0.5\n"
          "0.5714285714285714 1.5714285714285714 4 0.5\n");
}

TEST_CASE("HDF5 frames behind the resumed state are dropped") {
    TemporaryFolder folder;
    const Path path = folder / "results.h5";
    auto body = makeBody<2>("water", 5);
    Hdf5Output<2> first({}, std::make_shared<ResultsFile>(path, Provenance{}),
                        {{body.get(), {"pressure"}}});
    const SavedState saved = writeFramesFrom(first, *body, 2, 5);
    Hdf5Output<2> second({}, std::make_shared<ResultsFile>(path, Provenance{}),
                         {{body.get(), {"velocity"}}});
    saved.restore(second);
    second.resume(clockOf(1));
    CHECK(hdf5::Reader(path).numbers("bodies/water/time") == std::vector<double>{0, 0.5});
    writeFrames(second, *body, 2, 4);
    const hdf5::Reader reader(path);
    CHECK(reader.numbers("bodies/water/time") == std::vector<double>{0, 0.5, 1, 1.5});
    CHECK(reader.integers("bodies/water/frame") == std::vector<std::int64_t>{0, 1, 2, 3});
    CHECK(reader.has("bodies/water/frame_000001/pressure"));
    CHECK_FALSE(reader.has("bodies/water/frame_000002/pressure"));
    CHECK(reader.has("bodies/water/frame_000003/velocity"));
    CHECK_FALSE(reader.has("bodies/water/frame_000004"));
    CHECK(reader.numbers("bodies/water/frame_000002/position")[2] == 1 / 7. + 0.5);
}

TEST_CASE("a VTKHDF file with other fields is kept beside the new one") {
    TemporaryFolder folder;
    auto body = makeBody<2>("water", 5);
    const FrameParameters parameters{folder.path(), false, {}, {}};
    VtkHdfOutput<2> first(parameters, {{body.get(), {"pressure"}}});
    const SavedState saved = writeFramesFrom(first, *body, 2, 3);
    VtkHdfOutput<2> second(parameters, {{body.get(), {"velocity"}}});
    saved.restore(second);
    second.resume(clockOf(1));
    writeFrames(second, *body, 2, 3);
    CHECK(names(folder.path()) ==
          std::vector<std::string>{"water.before_10.vtkhdf", "water.vtkhdf"});
    CHECK(hdf5::Reader(folder / "water.before_10.vtkhdf").numbers("VTKHDF/Steps/Values") ==
          std::vector<double>{0, 0.5, 1});
    CHECK(hdf5::Reader(folder / "water.vtkhdf").numbers("VTKHDF/Steps/Values") ==
          std::vector<double>{1});
}

TEST_CASE("results files are not overwritten, and foreign ones not continued") {
    TemporaryFolder folder;
    auto body = makeBody<2>("water", 5);
    const FrameParameters parameters{folder.path(), false, {}, {}};
    File::create(folder / "water.vtkhdf").write(std::string(100, 'x'));
    VtkHdfOutput<2> output(parameters, {{body.get(), {}}});
    CHECK_THROWS_WITH(output.write(clockOf(0)), Catch::Contains("it exists already"));
    CHECK_THROWS_WITH(output.resume(clockOf(0)), Catch::Contains("it is not an HDF5 file"));
}
