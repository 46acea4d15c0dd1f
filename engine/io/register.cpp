// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/register.h"

#include "io/frames/body_selection.h"
#include "io/frames/hdf5.h"
#include "io/frames/tecplot.h"
#include "io/frames/vtkhdf.h"
#include "io/frames/vtu.h"
#include "io/output/progress.h"
#include "io/restart/output.h"

namespace sphinx::io {
namespace {

using input::Component;

enum class Precision { full, single };

struct FrameSettings {
    BodySelection bodies;

    bool single() const { return false; }
};
struct NumberFrameSettings : FrameSettings {
    Precision precision = Precision::full;

    bool single() const { return precision == Precision::single; }
};

/// Declares an output of frames with the parameters that all of them share. make: []<int Dim>(
/// const P&, const OutputContext<Dim>&, std::vector<BodyFrames<Dim>>).
template <class P, class Make>
void declareFrames(input::Registry& registry, const char* name, const char* summary, Make make) {
    auto& d = registry.declare<P>(input::Kind::output, name);
    d.summary(summary);
    d.optional("bodies", &P::bodies, bodySelection(),
               "what is written; default: velocity, density and pressure of every fluid, velocity "
               "and normal of every solid. Position, id and mass are always there");
    if constexpr (std::is_same_v<P, NumberFrameSettings>)
        d.optional("precision", &P::precision,
                   input::choice<Precision>({
                       {"double", Precision::full, "64-bit numbers"},
                       {"single", Precision::single,
                        "32-bit numbers: half the size; places stay in 64 bits"},
                   }),
                   "of the numbers in the files");
    d.builder(outputFactory<P>(
        [make]<int Dim>(const P& p, const Component&, const OutputContext<Dim>& context) {
            return make(p, context, selectFrames(p.bodies, context.world));
        }));
}

/// Of frames in files of their own.
template <template <int> class Frames, class P>
void declareFrameFiles(input::Registry& registry, const char* name, const char* summary) {
    declareFrames<P>(
        registry, name, summary,
        []<int Dim>(const P& p, const OutputContext<Dim>& context,
                    std::vector<BodyFrames<Dim>> frames) {
            return std::make_unique<Frames<Dim>>(
                FrameParameters{context.folder, p.single(), context.units, context.provenance},
                std::move(frames));
        });
}

void declareHdf5(input::Registry& registry) {
    using P = NumberFrameSettings;
    declareFrames<P>(
        registry, "hdf5", "Frames as plain datasets in results.h5: bodies/BODY/frame_NNNNNN/FIELD",
        []<int Dim>(const P& p, const OutputContext<Dim>& context,
                    std::vector<BodyFrames<Dim>> frames) {
            return std::make_unique<Hdf5Output<Dim>>(Hdf5Parameters{p.single(), context.units},
                                                     context.results, std::move(frames));
        });
}

struct ProgressSettings {};

void declareProgress(input::Registry& registry) {
    using P = ProgressSettings;
    auto& d = registry.declare<P>(input::Kind::output, "progress");
    d.summary("Time, steps, speed and time left, on the terminal and in the log");
    d.builder(outputFactory<P>(
        []<int Dim>(const P&, const Component&, const OutputContext<Dim>& context) {
            return std::make_unique<ProgressOutput>(
                ProgressParameters{onTerminal(), context.units.text(unit::time)}, context.progress);
        }));
}

void declareRestart(input::Registry& registry) {
    using P = RestartSettings;
    auto& d = registry.declare<P>(input::Kind::output, "restart");
    d.summary(
        "States from which a run goes on with the same bits: restart/NAME_STEP.xml. Without such "
        "an output, a run keeps the state at which it ends. A run that fails leaves the state "
        "of some steps before");
    d.optional("keep", &P::keep, input::integer().atLeast(1), "newest files that stay");
    d.optional("encoding", &P::encoding,
               input::choice<RestartEncoding>({
                   {"base64", RestartEncoding::zlib, "compressed bytes"},
                   {"text", RestartEncoding::text, "decimals that read back as the same bits"},
               }),
               "how the values of particles are written");
}

}  // namespace

void registerOutputs(input::Registry& registry) {
    declareFrameFiles<VtuOutput, NumberFrameSettings>(
        registry, "vtu", "Frames for ParaView: BODY_NNNNNN.vtu and one BODY.pvd a body");
    declareFrameFiles<VtkHdfOutput, NumberFrameSettings>(
        registry, "vtkhdf",
        "Frames as one time series BODY.vtkhdf a body, for ParaView from 5.12 on; while the run "
        "writes it, look at a copy: readers of VTK may fail on a file that grows");
    declareHdf5(registry);
    declareFrameFiles<TecplotOutput, FrameSettings>(registry, "tecplot",
                                                    "Frames as Tecplot text: BODY_NNNNNN.dat");
    declareProgress(registry);
    declareRestart(registry);
}

}  // namespace sphinx::io
