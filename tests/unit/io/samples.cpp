// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// Writes the files that tests/regression/readers open with other programs. Hidden: it runs as
// `SPHINX_SAMPLES=FOLDER unit_io "[.samples]"`.
#include "core/types.h"
#include "io/frames/hdf5.h"
#include "io/frames/tecplot.h"
#include "io/frames/vtkhdf.h"
#include "io/frames/vtu.h"
#include "io/restart/restart.h"
#include "io/series/series.h"
#include "support.h"

#include <catch2/catch.hpp>

using namespace sphinx;
using namespace sphinx::io;
using namespace sphinx::test;

namespace {

const Provenance provenance{{{"version", "1.2.3"}, {"compiler", "g++ <12> & \xc3\xa9"}}};

template <int Dim>
struct Frames {
    std::unique_ptr<bodies::Body<Dim>> water = makeBody<Dim>("water", 1500);
    std::unique_ptr<bodies::Body<Dim>> wall = makeBody<Dim>("wall", 7);
    std::vector<BodyFrames<Dim>> bodies{{water.get(), {"velocity", "pressure", "strain"}},
                                        {wall.get(), {}}};
    std::vector<std::unique_ptr<Output>> outputs;

    Frames(const Path& folder, bool single) {
        makeFolder(folder);
        const input::UnitSystem units;
        const auto add = [&](auto output) { outputs.push_back(std::move(output)); };
        add(std::make_unique<VtuOutput<Dim>>(FrameParameters{folder, single, units, provenance},
                                             bodies));
        add(std::make_unique<VtkHdfOutput<Dim>>(FrameParameters{folder, single, units, provenance},
                                                bodies));
        add(std::make_unique<Hdf5Output<Dim>>(
            Hdf5Parameters{single, units},
            std::make_shared<ResultsFile>(folder / "results.h5", provenance), bodies));
        add(std::make_unique<TecplotOutput<Dim>>(FrameParameters{folder, false, units, provenance},
                                                 bodies));
    }
    void write(int frame) {
        if (frame == 2 && water->size() == 1500) water->particles.remove({3});
        setValues(*water, frame);
        setValues(*wall, frame < 3 ? 0 : frame);
        for (auto& output : outputs) output->write(clockOf(frame));
    }
    static Clock clockOf(int frame) {
        Clock clock;
        clock.time = 0.1 * frame;
        clock.steps = 10 * frame;
        return clock;
    }
};

template <int Dim>
void writeFrames(const Path& folder, bool single) {
    Frames<Dim> run(folder, single);
    for (int frame = 0; frame < 4; ++frame) run.write(frame);
    for (auto& output : run.outputs) output->finish();
}

/// Two frames too many, with other values, and a restart that knows of two.
void writeResumed(const Path& folder) {
    std::vector<SavedState> saved;
    {
        Frames<2> run(folder, false);
        run.write(0);
        run.write(1);
        for (auto& output : run.outputs) saved.emplace_back(*output);
        run.write(7);
        run.write(8);
    }
    Frames<2> run(folder, false);
    for (std::size_t k = 0; k < saved.size(); ++k) {
        saved[k].restore(*run.outputs[k]);
        run.outputs[k]->resume(run.clockOf(1));
    }
    run.write(2);
    run.write(3);
}

class Probe final : public SeriesSource {
 public:
    const std::vector<SeriesQuantity>& quantities() const override { return quantities_; }
    void sample(const Clock& clock, std::span<double> row) override {
        for (std::size_t k = 0; k < row.size(); ++k)
            row[k] = clock.steps == 2 ? nan_value : clock.time / 3 + static_cast<double>(k);
    }

 private:
    std::vector<SeriesQuantity> quantities_{
        {"pressure", "Pa", "pressure at the probe", {}},
        {"velocity", "m/s", "velocity at the probe", {"x", "y"}}};
};

void writeSeries(const Path& folder, int rows) {
    makeFolder(folder);
    SeriesOutput output({folder, "probe", "s", true,
                         std::make_shared<ResultsFile>(folder / "results.h5", provenance)},
                        std::make_unique<Probe>());
    for (int row = 0; row < rows; ++row) {
        Clock clock;
        clock.time = 0.1 * row;
        clock.steps = row;
        output.write(clock);
    }
}

void writeRestarts(const Path& folder) {
    makeFolder(folder);
    auto water = makeBody<2>("water", 20000);  // strain: two pieces
    setValues(*water, 1);
    water->particles.scalar(fields::pressure)[5] = -nan_value;
    const StateTransfer state = [](Archive& archive) {
        double numbers[]{0.1, -nan_value, nan_value, -1e300 * 1e300, 1e-310};
        std::int64_t steps = 12;
        std::string text = "a <b>", binary("\0\1", 2);
        Section section(archive, "loop & all");
        for (int k = 0; k < 5; ++k) archive.value("number" + std::to_string(k), numbers[k]);
        archive.value("steps", steps);
        archive.value("text", text);
        archive.value("binary", binary);
        bool flag = false;
        std::vector<double> offsets{0.1, -nan_value, -1e300 * 1e300};
        std::vector<std::int64_t> ids{3, -4};
        archive.value("flag", flag);
        archive.value("offsets", offsets);
        archive.value("ids", ids);
    };
    RestartHeader header;
    header.program = "1.2.3";
    header.commit = "abc";
    header.case_name = "tank";
    header.case_text = "title: a & b\n";
    header.time = 0.1;
    header.steps = 10;
    for (const auto& [name, encoding] : {std::pair("zlib.xml", RestartEncoding::zlib),
                                         std::pair("text.xml", RestartEncoding::text)})
        writeRestart<2>(folder / name, header, state,
                        {{water.get(), {"velocity", "pressure", "strain"}}}, encoding);
}

}  // namespace

TEST_CASE("samples for other readers", "[.samples]") {
    const char* target = std::getenv("SPHINX_SAMPLES");
    REQUIRE(target);
    writeFrames<2>(Path(target) / "frames_2d", false);
    writeFrames<3>(Path(target) / "frames_3d", false);
    writeFrames<3>(Path(target) / "frames_single", true);
    writeResumed(Path(target) / "frames_resumed");
    writeSeries(Path(target) / "series", 2500);
    writeRestarts(Path(target) / "restart");
}

TEST_CASE("samples until somebody kills the process", "[.endless]") {
    const char* target = std::getenv("SPHINX_SAMPLES");
    REQUIRE(target);
    Frames<2> run(target, false);
    for (int frame = 0; frame < 100000; ++frame) run.write(frame);
}
