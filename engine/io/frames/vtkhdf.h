// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "io/frames/arrays.h"
#include "io/frames/parameters.h"

#include <memory>

namespace sphinx::io {

/// One BODY.vtkhdf a body: its frames as a time series (transient PolyData of VTKHDF 2.0, points
/// with vertex cells) that ParaView from 5.12 on opens. An array that did not change since the last
/// frame is stored once; the step refers to it again. The file is valid after every write
/// (io/hdf5/file.h).
/// A step's rows begin at a multiple of the chunk size; readers find them by the offsets.
template <int Dim>
class VtkHdfOutput final : public Output {
 public:
    VtkHdfOutput(FrameParameters parameters, std::vector<BodyFrames<Dim>> bodies);
    ~VtkHdfOutput() override;

    std::vector<OutputFile> files() const override;
    FileWork take(const Clock& clock) override;
    void transfer(Archive& archive) override;
    /// If the fields of a body changed since its file was begun, the old file is kept as
    /// BODY.before_STEP.vtkhdf and a new one begun.
    void resume(const Clock& clock) override;

 private:
    class Series;  // of one body

    FrameParameters parameters_;
    std::vector<std::unique_ptr<Series>> series_;
    std::int64_t frames_ = 0;
};

}  // namespace sphinx::io
