// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/vtkhdf_layout.h"

#include "core/errors.h"
#include "io/hdf5/reader.h"

#include <algorithm>

namespace sphinx::io::hdf5 {
namespace {

// A body may begin with few particles and grow: chunks of one particle would not scale.
constexpr std::uint32_t least_chunk_rows = 1024;

std::uint32_t chunkRows(std::size_t rows) { return std::max(chunkRowsFor(rows), least_chunk_rows); }

std::shared_ptr<SmallArray> integers(Group& group, const std::string& name,
                                     Dimensions row_shape = {}) {
    return group.put(name, std::make_shared<SmallArray>(Number::int64, std::move(row_shape)));
}

std::string bytesOfNumbers(std::int64_t first, std::size_t count) {
    std::string bytes(8 * count, '\0');
    for (std::size_t k = 0; k < count; ++k) {
        const std::int64_t value = first + static_cast<std::int64_t>(k);
        std::copy_n(reinterpret_cast<const char*>(&value), 8, bytes.data() + 8 * k);
    }
    return bytes;
}

}  // namespace

VtkHdfLayout::VtkHdfLayout(std::vector<VtkHdfArray> arrays, std::size_t points)
    : descriptions_(std::move(arrays)) {
    top_ = root_.put("VTKHDF", std::make_shared<Group>());
    top_->setAttributes(
        {{"Version", std::vector<std::int64_t>{2, 0}}, {"Type", std::string("PolyData")}});
    number_of_points_ = integers(*top_, "NumberOfPoints");
    steps_ = top_->put("Steps", std::make_shared<Group>());
    auto data = top_->put("PointData", std::make_shared<Group>());
    auto data_offsets = steps_->put("PointDataOffsets", std::make_shared<Group>());
    for (std::size_t a = 0; a < descriptions_.size(); ++a) {
        const VtkHdfArray& description = descriptions_[a];
        Dimensions row_shape;
        if (description.components > 1)
            row_shape = {static_cast<std::uint64_t>(description.components)};
        auto array =
            std::make_shared<ChunkedArray>(description.type, row_shape, chunkRows(points), true);
        array->setAttributes(description.attributes);
        arrays_.push_back(array);
        if (a == 0)
            top_->put("Points", array);
        else
            data->put(description.name, array);
        data_offsets_.push_back(a == 0 ? integers(*steps_, "PointOffsets")
                                       : integers(*data_offsets, description.name));
    }

    auto vertices = top_->put("Vertices", std::make_shared<Group>());
    vertex_counts_ = integers(*vertices, "NumberOfCells");
    vertex_ids_ = integers(*vertices, "NumberOfConnectivityIds");
    const auto topology = [&](const char* name, std::size_t rows) {
        return vertices->put(name, std::make_shared<ChunkedArray>(Number::int64, Dimensions{},
                                                                  chunkRows(rows), true));
    };
    connectivity_ = topology("Connectivity", points);
    offsets_ = topology("Offsets", points + 1);
    for (const char* kind : {"Lines", "Polygons", "Strips"}) {
        auto cells = top_->put(kind, std::make_shared<Group>());
        integers(*cells, "Connectivity");
        for (const char* name : {"NumberOfCells", "NumberOfConnectivityIds", "Offsets"})
            empty_cells_.push_back(integers(*cells, name));
    }

    values_ = steps_->put("Values", std::make_shared<SmallArray>(Number::float64, Dimensions{}));
    part_offsets_ = integers(*steps_, "PartOffsets");
    part_counts_ = integers(*steps_, "NumberOfParts");
    cell_offsets_ = integers(*steps_, "CellOffsets", {4});
    connectivity_offsets_ = integers(*steps_, "ConnectivityIdOffsets", {4});

    // Our own notes, for a run that goes on in this file.
    auto notes = root_.put("sphinx", std::make_shared<Group>());
    frame_ = integers(*notes, "frame");
    first_offsets_ = integers(*notes, "first_offset");
    first_cells_ = integers(*notes, "first_cell");
}

std::int64_t VtkHdfLayout::part(SafeFile& file, std::size_t points) {
    const auto count = static_cast<std::int64_t>(points);
    if (parts_.empty() || parts_.back().points != count) {
        Part part{count, 0, 0};
        part.first_cell =
            static_cast<std::int64_t>(connectivity_->appendChunks(file, bytesOfNumbers(0, points)));
        part.first_offset =
            static_cast<std::int64_t>(offsets_->appendChunks(file, bytesOfNumbers(0, points + 1)));
        addPart(part);
    }
    return static_cast<std::int64_t>(parts_.size()) - 1;
}

void VtkHdfLayout::addPart(const Part& part) {
    parts_.push_back(part);
    number_of_points_->append({part.points});
    vertex_counts_->append({part.points});
    vertex_ids_->append({part.points});
    first_offsets_->append({part.first_offset});
    first_cells_->append({part.first_cell});
    for (auto& array : empty_cells_) array->append({std::int64_t{0}});
}

std::int64_t VtkHdfLayout::append(SafeFile& file, std::size_t array, std::string_view rows) {
    return static_cast<std::int64_t>(arrays_[array]->appendChunks(file, rows));
}

void VtkHdfLayout::addStep(const VtkHdfStep& step) {
    const Part& part = parts_[static_cast<std::size_t>(step.part)];
    steps_->setAttributes({{"NSteps", ++step_count_}});
    values_->append({step.time});
    frame_->append({step.frame});
    part_offsets_->append({step.part});
    part_counts_->append({std::int64_t{1}});
    // Readers add the number of the part to an offset of cells, because each part before it has
    // one more offset than cells.
    const std::int64_t none = 0;
    cell_offsets_->append({part.first_offset - step.part, none, none, none});
    connectivity_offsets_->append({part.first_cell, none, none, none});
    for (std::size_t a = 0; a < step.rows.size(); ++a) data_offsets_[a]->append({step.rows[a]});
    last_step_ = step;
}

std::string VtkHdfLayout::arrayPlace(std::size_t array) const {
    return array == 0 ? "VTKHDF/Points" : "VTKHDF/PointData/" + descriptions_[array].name;
}

bool VtkHdfLayout::load(const Path& path, std::int64_t frames) {
    const Reader reader(path);
    if (!reader.has("VTKHDF/PointData") || !reader.has("sphinx/frame"))
        throw FileError("cannot continue " + path.string() + ": sphinx did not write it");
    if (reader.members("VTKHDF/PointData").size() + 1 != arrays_.size()) return false;
    std::vector<StoredArray> stored;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
        if (!reader.has(arrayPlace(a))) return false;
        stored.push_back(reader.array(arrayPlace(a)));
        Dimensions row_shape;
        if (descriptions_[a].components > 1)
            row_shape = {static_cast<std::uint64_t>(descriptions_[a].components)};
        if (stored[a].type != descriptions_[a].type || stored[a].row_shape != row_shape ||
            !stored[a].filtered)
            return false;
    }

    // Steps and parts to keep.
    const auto column = [&](const std::string& name) { return reader.integers(name); };
    const std::vector<std::int64_t> frame = column("sphinx/frame");
    const std::vector<std::int64_t> part = column("VTKHDF/Steps/PartOffsets");
    const std::vector<double> time = reader.numbers("VTKHDF/Steps/Values");
    const std::vector<std::int64_t> points = column("VTKHDF/NumberOfPoints");
    const std::vector<std::int64_t> first_offset = column("sphinx/first_offset");
    const std::vector<std::int64_t> first_cell = column("sphinx/first_cell");
    std::vector<std::vector<std::int64_t>> rows;
    for (std::size_t a = 0; a < arrays_.size(); ++a)
        rows.push_back(column(a == 0 ? "VTKHDF/Steps/PointOffsets"
                                     : "VTKHDF/Steps/PointDataOffsets/" + descriptions_[a].name));
    std::size_t steps = 0;
    while (steps < frame.size() && frame[steps] < frames) ++steps;
    bool sound = time.size() >= steps && part.size() >= steps &&
                 first_offset.size() == points.size() && first_cell.size() == points.size();
    for (const auto& list : rows) sound = sound && list.size() >= steps;
    std::int64_t parts = 0;
    for (std::size_t s = 0; sound && s < steps; ++s) {
        sound = part[s] >= 0 && part[s] < static_cast<std::int64_t>(points.size());
        parts = std::max(parts, part[s] + 1);
    }
    if (!sound)
        throw FileError("cannot continue " + path.string() + ": its steps do not fit together");

    // Rows behind the last kept step are dropped.
    const auto adopt = [](ChunkedArray& array, StoredArray from, std::int64_t end) {
        const auto kept = std::min(static_cast<std::uint64_t>(end), from.rows);
        array.adopt(std::move(from.chunks), from.chunk_rows, kept);
    };
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
        std::int64_t end = 0;
        for (std::size_t s = 0; s < steps; ++s)
            end = std::max(end, rows[a][s] + points[static_cast<std::size_t>(part[s])]);
        adopt(*arrays_[a], std::move(stored[a]), end);
    }
    std::int64_t end_cell = 0, end_offset = 0;
    for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p) {
        addPart({points[p], first_offset[p], first_cell[p]});
        end_cell = std::max(end_cell, first_cell[p] + points[p]);
        end_offset = std::max(end_offset, first_offset[p] + points[p] + 1);
    }
    adopt(*connectivity_, reader.array("VTKHDF/Vertices/Connectivity"), end_cell);
    adopt(*offsets_, reader.array("VTKHDF/Vertices/Offsets"), end_offset);
    steps_->setAttributes({{"NSteps", std::int64_t{0}}});
    for (std::size_t s = 0; s < steps; ++s) {
        VtkHdfStep step{time[s], frame[s], part[s], {}};
        for (const auto& list : rows) step.rows.push_back(list[s]);
        addStep(step);
    }
    return true;
}

}  // namespace sphinx::io::hdf5
