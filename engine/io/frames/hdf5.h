// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/output.h"
#include "input/expressions/units.h"
#include "io/frames/arrays.h"
#include "io/hdf5/results_file.h"

#include <memory>

namespace sphinx::io {

struct Hdf5Parameters {
    bool single_precision = false;  ///< numbers as 32-bit floats; ids stay 64-bit integers
    input::UnitSystem units;
};

/// Frames of particles in results.h5:
///   bodies/BODY/time, step, frame        one value a frame
///   bodies/BODY/frame_000012/FIELD       [particles], [particles x Dim], [particles x Dim x Dim],
///                                        attributes unit and description
/// A field that did not change since the last frame is stored once and linked again.
template <int Dim>
class Hdf5Output final : public Output {
 public:
    Hdf5Output(Hdf5Parameters parameters, std::shared_ptr<ResultsFile> file,
               std::vector<BodyFrames<Dim>> bodies);
    ~Hdf5Output() override;

    std::vector<OutputFile> files() const override;
    FileWork take(const Clock& clock) override;
    void transfer(Archive& archive) override { archive.count("frames", frames_); }
    void resume(const Clock& clock) override;

 private:
    struct Series;  // of one body

    struct Frame;  // of one of them

    void open();
    void writeFrames(const std::vector<Frame>& frames, const Clock& clock, std::int64_t number);
    std::shared_ptr<hdf5::ChunkedArray> store(const particles::FieldInfo& field,
                                              const ArrayCopy& array, std::size_t particles);

    Hdf5Parameters parameters_;
    std::shared_ptr<ResultsFile> file_;
    std::vector<std::unique_ptr<Series>> series_;
    std::int64_t frames_ = 0;
    bool open_ = false;
};

}  // namespace sphinx::io
