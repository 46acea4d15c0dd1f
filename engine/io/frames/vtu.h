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
/// Every file is complete or absent at any moment, and the .pvd names only complete ones; a power
/// failure may spoil those after the last restart, with which a run that goes on begins anew.
template <int Dim>
class VtuOutput final : public Output {
 public:
    VtuOutput(FrameParameters parameters, std::vector<BodyFrames<Dim>> bodies);
    ~VtuOutput() override;

    std::vector<OutputFile> files() const override;
    FileWork take(const Clock& clock) override;
    void sync() override { unsynced_.sync(); }
    void transfer(Archive& archive) override;
    void resume(const Clock& clock) override;

 private:
    struct Series;  // of one body

    struct Frame;  // of one of them

    void writeFrames(const std::vector<Frame>& frames, double time, std::int64_t number);
    void writeFrame(Series& series, const Frame& frame, double time);

    FrameParameters parameters_;
    std::vector<std::unique_ptr<Series>> series_;
    std::int64_t frames_ = 0;
    UnsyncedFiles unsynced_;
};

}  // namespace sphinx::io
