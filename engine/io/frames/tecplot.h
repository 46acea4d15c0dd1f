// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "io/frames/arrays.h"
#include "io/frames/parameters.h"

namespace sphinx::io {

/// Frames as Tecplot ASCII: one BODY_NNNNNN.dat a frame, with one zone in POINT format that carries
/// SOLUTIONTIME and the STRANDID of the body, so that Tecplot joins the files to a time series.
/// One file a frame, because a zone cut short by a crash would spoil all zones in its file.
/// A body without particles has no frame: the format has no empty zones. (ParaView reads the other
/// formats better: its Tecplot reader takes no one-dimensional zones.)
template <int Dim>
class TecplotOutput final : public Output {
 public:
    TecplotOutput(FrameParameters parameters, const std::vector<BodyFrames<Dim>>& bodies);

    std::vector<OutputFile> files() const override;
    FileWork take(const Clock& clock) override;
    void sync() override { unsynced_.sync(); }
    void transfer(Archive& archive) override { archive.count("frames", frames_); }
    void resume(const Clock& clock) override;

 private:
    struct Series {
        const bodies::Body<Dim>* body = nullptr;
        std::vector<const particles::FieldBase*> fields;  // position first
        std::string variables;
    };
    struct Frame;  // of one of them

    void writeFrames(const std::vector<Frame>& frames, double time, std::int64_t number);

    FrameParameters parameters_;
    std::vector<Series> series_;
    std::int64_t frames_ = 0;
    UnsyncedFiles unsynced_;
};

}  // namespace sphinx::io
