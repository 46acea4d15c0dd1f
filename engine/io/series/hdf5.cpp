// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/hdf5.h"

#include "core/log.h"
#include "io/hdf5/reader.h"

#include <algorithm>

namespace sphinx::io {

using namespace hdf5;

namespace {

std::uint32_t chunkRowsOf(std::size_t row_bytes) {
    return static_cast<std::uint32_t>(std::clamp<std::size_t>(32768 / row_bytes, 1, 1024));
}

Attributes attributesOf(const SeriesQuantity& quantity) {
    Attributes attributes{{"unit", quantity.unit}, {"description", quantity.description}};
    std::size_t longest = 0;
    for (const std::string& label : quantity.labels) longest = std::max(longest, label.size());
    // Attributes are limited to 64 kB; the labels of so many values are their numbers.
    if (longest > 0 && longest * quantity.labels.size() < max_message - 1024)
        attributes.push_back({"labels", quantity.labels});
    return attributes;
}

}  // namespace

Hdf5Series::Hdf5Series(std::shared_ptr<ResultsFile> file, const std::string& name,
                       const std::string& time_unit, const std::vector<SeriesQuantity>& quantities)
    : file_(std::move(file)), name_(name), group_(std::make_shared<Group>()) {
    const auto add = [&](const SeriesQuantity& quantity) {
        Column column{quantity.name, quantity.size(), nullptr};
        Dimensions row_shape;
        if (!quantity.labels.empty()) row_shape = {quantity.labels.size()};
        column.array = std::make_shared<ChunkedArray>(Number::float64, row_shape,
                                                      chunkRowsOf(8 * column.width), false);
        column.array->setAttributes(attributesOf(quantity));
        group_->put(column.name, column.array);
        columns_.push_back(std::move(column));
    };
    add({"time", time_unit, "time of each row", {}});
    for (const SeriesQuantity& quantity : quantities) add(quantity);
}

void Hdf5Series::open() {
    if (open_) return;
    file_->open();
    file_->series().put(name_, group_);
    open_ = true;
}

void Hdf5Series::append(std::span<const double> row) {
    open();
    for (Column& column : columns_) {
        const std::span<const double> values = row.first(column.width);
        column.array->appendRow(
            file_->file(), {reinterpret_cast<const char*>(values.data()), values.size_bytes()});
        row = row.subspan(column.width);
    }
    file_->commit(false);
}

void Hdf5Series::resume(const Clock& clock) {
    file_->resume();
    const Reader reader(file_->path());
    const std::string place = "series/" + name_;
    if (reader.has(place)) {
        bool same = reader.members(place).size() == columns_.size();
        std::vector<StoredArray> stored;
        for (const Column& column : columns_) {
            const std::string dataset = place + "/" + column.name;
            same = same && reader.has(dataset);
            if (!same) break;
            stored.push_back(reader.array(dataset));
            same = stored.back().row_shape == column.array->rowShape() &&
                   stored.back().type == Number::float64 && !stored.back().filtered;
        }
        if (same) {
            const std::vector<double> times = reader.numbers(place + "/time");
            std::uint64_t rows = static_cast<std::uint64_t>(
                std::upper_bound(times.begin(), times.end(), clock.time) - times.begin());
            for (const StoredArray& array : stored) rows = std::min(rows, array.rows);
            for (std::size_t c = 0; c < columns_.size(); ++c)
                columns_[c].array->adopt(std::move(stored[c].chunks), stored[c].chunk_rows, rows);
        } else {
            const std::string kept = name_ + ".before_" + std::to_string(clock.steps);
            for (const Link& link : reader.members("series"))
                if (link.name == name_)
                    file_->series().put(kept, std::make_shared<StoredNode>(link.address));
            log::warning(file_->path().string() + " holds other quantities in " + place +
                         " than the case now asks for; they are kept as series/" + kept);
        }
    }
    open();
    file_->commit(false);
}

}  // namespace sphinx::io
