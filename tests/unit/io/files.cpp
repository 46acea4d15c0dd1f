// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/file/file.h"

#include "core/errors.h"
#include "io/output/folder.h"
#include "io/output/progress.h"
#include "support.h"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

TEST_CASE("failures name the file and the reason") {
    TemporaryFolder folder;
    CHECK_THROWS_WITH(File::openRead(folder / "none"),
                      "cannot read " + (folder / "none").string() + ": No such file or directory");
    CHECK_THROWS_WITH(File::create(folder.path()),
                      "cannot write " + folder.path().string() + ": Is a directory");
    CHECK_THROWS_WITH(File::openRead(folder.path()), Catch::Contains("Is a directory"));
    CHECK_THROWS_WITH(File::create("/dev/full").write("x"),
                      "cannot write /dev/full: No space left on device");
    CHECK_THROWS_WITH(makeFolder("/dev/null/x"), Catch::Contains("Not a directory"));
    File::create(folder / "file").write("12345");
    CHECK_THROWS_WITH(makeFolder(folder / "file"), Catch::Contains("create folder"));
    CHECK_THROWS_WITH(readFile(folder / "file", 4), Catch::Contains("more than the 4 bytes"));
    CHECK_NOTHROW(removeFile(folder / "none"));
}

TEST_CASE("an atomic file is complete or not there") {
    TemporaryFolder folder;
    const Path path = folder / "file";
    writeFileAtomically(path, "old");
    {
        AtomicFile file(path);
        file.write("new");
    }
    CHECK(readFile(path, 10) == "old");
    CHECK_FALSE(std::filesystem::exists(temporaryName(path)));
    writeFileAtomically(path, "new");
    CHECK(readFile(path, 10) == "new");

    // The disk is full in the middle of it.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    CHECK_THROWS_WITH(writeFileAtomically(path, std::string(2000, 'x')),
                      "cannot write " + temporaryName(path).string() + ": File too large");
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(readFile(path, 10) == "new");
    CHECK_FALSE(std::filesystem::exists(temporaryName(path)));
}

TEST_CASE("a results folder is never overwritten silently") {
    TemporaryFolder folder;
    const Path path = folder / "output/tank";
    {
        OutputFolder output(path, ExistingResults::refuse);
        CHECK_THROWS_WITH(OutputFolder(path, ExistingResults::keep),
                          "another run is writing to " + path.string());
    }
    OutputFolder(path, ExistingResults::refuse);  // still empty
    File::create(path / "notes").write("mine");
    CHECK_THROWS_WITH(OutputFolder(path, ExistingResults::refuse),
                      Catch::Contains("is not empty and holds no results of sphinx"));
    CHECK_THROWS_WITH(OutputFolder(path, ExistingResults::replace),
                      Catch::Contains("is not a folder of results"));
    OutputFolder(path, ExistingResults::keep);
    CHECK(std::filesystem::exists(path / "notes"));
    File::create(path / resolved_case_name).write("sphinx: 2");
    OutputFolder(path, ExistingResults::replace);
    CHECK(std::filesystem::is_empty(path));
}

TEST_CASE("progress in words") {
    Progress progress;
    progress.time = 1.25;
    progress.end_time = 20;
    progress.fraction = 0.0625;
    progress.steps = 1200;
    CHECK(progressText(progress, "") == "time 1.25 of 20 (6.2 %), step 1200");
    progress.dt = 0.0031;
    progress.steps_per_second = 812.4;
    progress.seconds_left = 1124.2;
    CHECK(progressText(progress, "s") ==
          "time 1.25 s of 20 s (6.2 %), step 1200, dt 0.0031 s, 812 steps/s, 0:18:45 left");
    CHECK(durationText(0) == "0:00:00");
    CHECK(durationText(86400 + 3661) == "1 day 1:01:01");
    CHECK(durationText(3 * 86400) == "3 days 0:00:00");
    CHECK(durationText(1e300) == "unknown time");
    CHECK(durationText(std::numeric_limits<double>::quiet_NaN()) == "unknown time");
}
