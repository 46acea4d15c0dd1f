// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/hdf5/nodes.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace sphinx::io::hdf5 {

/// One array of points: the position or a field.
struct VtkHdfArray {
    std::string name;
    Number type = Number::float64;
    int components = 1;
    Attributes attributes;
};

/// What one step of the time series refers to.
struct VtkHdfStep {
    double time = 0;
    std::int64_t frame = 0;          ///< number of the frame since the start of the run
    std::int64_t part = 0;           ///< from VtkHdfLayout::part
    std::vector<std::int64_t> rows;  ///< first row of each array, from VtkHdfLayout::append
};

/// The groups and datasets of a transient PolyData file, VTKHDF version 2.0
/// (https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html): arrays of all steps one
/// behind the other, and for each step where its rows begin. A `part` is a number of points with
/// its vertex cells; steps with as many points share one.
class VtkHdfLayout {
 public:
    /// The first array is the position. `points`: of the first step, for the size of chunks.
    VtkHdfLayout(std::vector<VtkHdfArray> arrays, std::size_t points);

    /// The last part if it has this many points, else a new one.
    std::int64_t part(SafeFile& file, std::size_t points);
    /// Stores rows of an array; returns where they begin.
    std::int64_t append(SafeFile& file, std::size_t array, std::string_view rows);
    void addStep(const VtkHdfStep& step);
    /// The step that was added or loaded last; frame -1 when there is none.
    const VtkHdfStep& lastStep() const { return last_step_; }

    /// Takes over the steps of an existing file with frame numbers below `frames`; false if its
    /// arrays are others than this layout's. Throws FileError.
    bool load(const Path& path, std::int64_t frames);

    Group& root() { return root_; }

 private:
    struct Part {
        std::int64_t points;
        std::int64_t first_offset;  // row of Vertices/Offsets
        std::int64_t first_cell;    // row of Vertices/Connectivity
    };

    void addPart(const Part& part);
    std::string arrayPlace(std::size_t array) const;

    std::vector<VtkHdfArray> descriptions_;
    std::vector<std::shared_ptr<ChunkedArray>> arrays_;
    std::vector<Part> parts_;

    Group root_;
    std::shared_ptr<Group> top_;
    std::shared_ptr<Group> steps_;
    std::shared_ptr<SmallArray> frame_, first_offsets_, first_cells_;
    std::shared_ptr<SmallArray> number_of_points_, vertex_counts_, vertex_ids_;
    std::vector<std::shared_ptr<SmallArray>> empty_cells_;  // one zero a part
    std::shared_ptr<ChunkedArray> connectivity_, offsets_;
    std::shared_ptr<SmallArray> values_, part_offsets_, part_counts_, point_offsets_;
    std::shared_ptr<SmallArray> cell_offsets_, connectivity_offsets_;
    std::vector<std::shared_ptr<SmallArray>> data_offsets_;
    std::int64_t step_count_ = 0;
    VtkHdfStep last_step_{0, -1, 0, {}};
};

}  // namespace sphinx::io::hdf5
