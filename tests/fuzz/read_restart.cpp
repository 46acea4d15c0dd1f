// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Any bytes as a restart: either it is refused with a FileError, or what it holds is sound.

#include "core/errors.h"
#include "io/file/compress.h"
#include "io/restart/restart.h"

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace sphinx;

namespace {

constexpr std::string_view beginning = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<restart ";

/// A file of this process that goes with it, in memory where there is such a place.
const io::Path& file() {
    static const io::Path path = [] {
        const char* memory = "/dev/shm";
        const io::Path folder = std::filesystem::is_directory(memory)
                                    ? io::Path(memory)
                                    : std::filesystem::temp_directory_path();
        const io::Path made = folder / ("fuzz_read_restart_" + std::to_string(getpid()) + ".xml");
        std::atexit([] { std::filesystem::remove(file()); });
        return made;
    }();
    return path;
}

struct Target {
    bodies::Body<2> water;
    std::vector<io::RestartBody<2>> bodies;

    Target() {
        water.name = "water";
        water.particles.vector(fields::velocity);
        water.particles.scalar(fields::density);
        bodies.push_back({&water, {"density", "velocity"}});
    }
};

void transfer(Archive& archive) {
    const Section loop(archive, "loop");
    double time = 0;
    std::int64_t steps = 0;
    std::string names;
    archive.value("time", time);
    archive.value("steps", steps);
    archive.value("names", names);
    bool flag = false;
    std::vector<double> numbers;
    std::vector<std::int64_t> integers;
    archive.value("flag", flag);
    archive.value("numbers", numbers);
    archive.value("integers", integers);
}

void read(std::string_view bytes) {
    io::File::create(file()).write(bytes);
    try {
        io::readRestartHeader(file());
        Target target;
        io::readRestart<2>(file(), transfer, target.bodies);
        auto& particles = target.water.particles;
        for (std::size_t i = 0; i < particles.size(); ++i)
            if (particles.id()[i] < 0 || particles.id()[i] >= particles.nextId()) std::abort();
    } catch (const FileError&) {
        return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    read(bytes);
    // With the checksums of a good file behind a good beginning, to get past the first look at it.
    std::string sound = bytes.starts_with(beginning) ? std::string() : std::string(beginning);
    sound += bytes;
    const std::size_t end = sound.rfind("<checksum");
    if (end != sound.npos) sound.resize(end);
    sound += io::restartEnd(io::checksum(sound));
    read(sound);
    return 0;
}
