// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "io/frames/arrays.h"
#include "io/frames/parameters.h"
#include "io/frames/pvd.h"

#include <memory>

namespace sphinx::io {

/// Frames for ParaView: one BODY_NNNNNN.vtu a frame (points with vertex cells, appended raw data in
/// zlib blocks) and one BODY.pvd with their times. A body in which nothing changed since its last
/// frame is not written again; the .pvd names the older file once more.
/// Every file is complete or absent at any moment, and the .pvd names only complete ones.
template <int Dim>
class VtuOutput final : public Output {
 public:
    VtuOutput(FrameParameters parameters, std::vector<BodyFrames<Dim>> bodies);
    ~VtuOutput() override;

    std::vector<OutputFile> files() const override;
    void write(const Clock& clock) override;
    void transfer(Archive& archive) override;
    void resume(const Clock& clock) override;

 private:
    struct Series;  // of one body

    void writeFrame(Series& series, const particles::IdOrder& order, const Path& path, double time);

    FrameParameters parameters_;
    ArrayGatherer<Dim> gatherer_;
    std::vector<std::unique_ptr<Series>> series_;
    std::int64_t frames_ = 0;
};

}  // namespace sphinx::io
