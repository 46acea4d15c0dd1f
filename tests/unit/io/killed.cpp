// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// What a killed run leaves behind. The writer is a child process that is stopped before and after
// each of its system calls; at every stop its files are what a kill at that moment would leave,
// and they have to open and hold whole frames.
#include "core/parallel.h"
#include "io/frames/hdf5.h"
#include "io/frames/vtkhdf.h"
#include "io/frames/vtu.h"
#include "io/hdf5/reader.h"
#include "io/restart/output.h"
#include "io/series/series.h"
#include "support.h"

#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

constexpr int frames = 4;
constexpr std::size_t particles = 1200;

class Probe final : public SeriesSource {
 public:
    const std::vector<SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override { row[0] = 2 * clock.time; }

 private:
    std::vector<SeriesQuantity> quantities_{{"pressure", "Pa", "", {}}};
};

void writeEverything(const Path& folder) {
    setThreadCount(1);  // threads of the parent do not exist here
    auto body = makeBody<2>("water", particles);
    auto wall = makeBody<2>("wall", 10);
    auto results = std::make_shared<ResultsFile>(folder / "results.h5", Provenance{});
    const std::vector<BodyFrames<2>> bodies{{body.get(), {"pressure"}}, {wall.get(), {}}};
    Hdf5Output<2> hdf5({}, results, bodies);
    VtkHdfOutput<2> vtkhdf({folder, false, {}, {}}, bodies);
    VtuOutput<2> vtu({folder, false, {}, {}}, bodies);
    SeriesOutput series({folder, "probe", "s", true, results}, std::make_unique<Probe>());
    RestartParameters parameters;
    parameters.folder = folder / "restart";
    parameters.keep = 1;
    parameters.header.case_name = "tank";
    RestartOutput<2> restart(parameters, {{body.get(), {"pressure"}}}, [](Archive&) {});
    for (int frame = 0; frame < frames; ++frame) {
        setValues(*body, frame);
        Clock clock;
        clock.time = frame;
        clock.steps = frame;
        for (Output* output : {static_cast<Output*>(&hdf5), static_cast<Output*>(&vtkhdf),
                               static_cast<Output*>(&vtu), static_cast<Output*>(&series),
                               static_cast<Output*>(&restart)})
            output->write(clock);
    }
}

double pressureOf(std::size_t id, std::size_t frame) {
    return 1 / (static_cast<double>(id) + 1) + static_cast<double>(frame);
}

/// Number of frames; -1 if something is wrong with one.
int framesInResults(const Path& path) {
    if (!std::filesystem::exists(path)) return 0;
    const hdf5::Reader reader(path);
    if (!reader.has("bodies/water")) return 0;
    const std::size_t count = reader.numbers("bodies/water/time").size();
    for (std::size_t f = 0; f < count; ++f) {
        const std::string frame = "bodies/water/" + frameName("frame", static_cast<int>(f), "");
        const std::vector<double> pressure = reader.numbers(frame + "/pressure");
        if (pressure.size() != particles || pressure[77] != pressureOf(77, f)) return -1;
    }
    if (reader.has("series/probe")) {
        const std::vector<double> times = reader.numbers("series/probe/time");
        const std::vector<double> values = reader.numbers("series/probe/pressure");
        if (times.size() != values.size()) return -1;
        for (std::size_t k = 0; k < times.size(); ++k)
            if (values[k] != 2 * times[k]) return -1;
    }
    return static_cast<int>(count);
}

int framesInVtkHdf(const Path& path) {
    if (!std::filesystem::exists(path)) return 0;
    const hdf5::Reader reader(path);
    if (!reader.has("VTKHDF")) return 0;
    const std::vector<double> pressure = reader.numbers("VTKHDF/PointData/pressure");
    const std::vector<std::int64_t> rows =
        reader.integers("VTKHDF/Steps/PointDataOffsets/pressure");
    for (std::size_t f = 0; f < rows.size(); ++f)
        if (pressure.at(static_cast<std::size_t>(rows[f]) + 77) != pressureOf(77, f)) return -1;
    return static_cast<int>(rows.size());
}

int framesInPvd(const Path& folder) {
    const std::vector<PvdEntry> entries = readPvd(folder / "water.pvd");
    for (const PvdEntry& entry : entries)
        if (!readFile(folder / entry.file, 1 << 20).ends_with("</VTKFile>\n")) return -1;
    return static_cast<int>(entries.size());
}

}  // namespace

TEST_CASE("files are valid at every system call of their writer") {
    TemporaryFolder folder;
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(2);
        ::raise(SIGSTOP);
        try {
            writeEverything(folder.path());
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFSTOPPED(status));
    int stops = 0, results = 0, vtkhdf = 0, vtu = 0;
    std::int64_t restart = -1;
    for (; WIFSTOPPED(status); ++stops) {
        // Frames never become fewer and never hold anything but what was written.
        const int results_now = framesInResults(folder / "results.h5");
        const int vtkhdf_now = framesInVtkHdf(folder / "water.vtkhdf");
        const int vtu_now = framesInPvd(folder.path());
        const RestartSearch search = findNewestValid(folder / "restart");
        const std::int64_t restart_now = search.found.empty() ? -1 : restartSteps(search.found);
        if (results_now < results || vtkhdf_now < vtkhdf || vtu_now < vtu ||
            restart_now < restart || !search.skipped.empty()) {
            CAPTURE(stops, results_now, vtkhdf_now, vtu_now, restart_now);
            FAIL_CHECK("a frame is lost or damaged");
            ::kill(child, SIGKILL);
        }
        results = results_now, vtkhdf = vtkhdf_now, vtu = vtu_now, restart = restart_now;
        ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
        ::waitpid(child, &status, 0);
    }
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(stops > 500);
    CHECK(results == frames);
    CHECK(vtkhdf == frames);
    CHECK(vtu == frames);
    CHECK(restart == frames - 1);
}
