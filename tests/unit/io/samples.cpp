// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Writes the files that tests/regression/readers open with other programs. Hidden: it runs as
// `SPHINX_SAMPLES=FOLDER unit_io "[.samples]"`.
#include "io/hdf5_output.h"
#include "io/vtkhdf.h"
#include "io/vtu.h"
#include "support.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

const Provenance provenance{{{"version", "1.2.3"}, {"compiler", "g++ <12> & \xc3\xa9"}}};

template <int Dim>
void writeFrames(const Path& folder, bool single) {
    makeFolder(folder);
    auto water = makeBody<Dim>("water", 1500);
    auto wall = makeBody<Dim>("wall", 7);
    const std::vector<BodyFrames<Dim>> bodies{{water.get(), {"velocity", "pressure", "strain"}},
                                              {wall.get(), {}}};
    VtuOutput<Dim> vtu({folder, single, {}, provenance}, bodies);
    VtkHdfOutput<Dim> vtkhdf({folder, single, {}, provenance}, bodies);
    Hdf5Output<Dim> hdf5({single, {}},
                         std::make_shared<ResultsFile>(folder / "results.h5", provenance), bodies);
    setValues(*wall, 0);
    for (int frame = 0; frame < 4; ++frame) {
        if (frame == 2) water->particles.remove({3});
        setValues(*water, frame);
        if (frame == 3) setValues(*wall, frame);
        Clock clock;
        clock.time = 0.1 * frame;
        clock.steps = 10 * frame;
        vtu.write(clock);
        vtkhdf.write(clock);
        hdf5.write(clock);
    }
    vtu.finish();
    vtkhdf.finish();
    hdf5.finish();
}

}  // namespace

TEST_CASE("samples for other readers", "[.samples]") {
    const char* target = std::getenv("SPHINX_SAMPLES");
    REQUIRE(target);
    writeFrames<2>(Path(target) / "frames_2d", false);
    writeFrames<3>(Path(target) / "frames_3d", false);
    writeFrames<3>(Path(target) / "frames_single", true);
}
