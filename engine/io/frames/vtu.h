// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "input/expressions/units.h"
#include "io/file/file.h"
#include "io/file/provenance.h"
#include "io/frames/arrays.h"
#include "io/frames/pvd.h"

#include <memory>

namespace sphinx::io {

struct VtuParameters {
    Path folder;
    bool single_precision = false;  ///< numbers as Float32; ids stay Int64
    input::UnitSystem units;
    Provenance provenance;
};

/// Frames for ParaView: one BODY_NNNNNN.vtu a frame (points with vertex cells, appended raw data in
/// zlib blocks) and one BODY.pvd with their times. A body in which nothing changed since its last
/// frame is not written again; the .pvd names the older file once more.
/// Every file is complete or absent at any moment, and the .pvd names only complete ones.
template <int Dim>
class VtuOutput final : public Output {
 public:
    VtuOutput(VtuParameters parameters, std::vector<BodyFrames<Dim>> bodies);
    ~VtuOutput() override;

    std::vector<OutputFile> files() const override;
    void write(const Clock& clock) override;
    void transfer(Archive& archive) override;
    void resume(const Clock& clock) override;

 private:
    struct Series;  // of one body

    void writeFrame(Series& series, const particles::IdOrder& order, const Path& path, double time);

    VtuParameters parameters_;
    ArrayGatherer<Dim> gatherer_;
    std::vector<std::unique_ptr<Series>> series_;
    std::int64_t frames_ = 0;
};

}  // namespace sphinx::io
