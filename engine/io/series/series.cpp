// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/series.h"

#include "core/errors.h"

#include <fmt/format.h>

namespace sphinx::io {

SeriesOutput::SeriesOutput(SeriesParameters parameters, std::unique_ptr<SeriesSource> source)
    : name_(parameters.name), source_(std::move(source)) {
    const std::vector<SeriesQuantity>& quantities = source_->quantities();
    for (const SeriesQuantity& quantity : quantities) width_ += quantity.size();
    if (parameters.csv)
        csv_.emplace(parameters.folder / (parameters.name + ".csv"), parameters.time_unit,
                     quantities);
    if (parameters.hdf5)
        hdf5_.emplace(parameters.hdf5, parameters.name, parameters.time_unit, quantities);
}

std::vector<OutputFile> SeriesOutput::files() const {
    constexpr double number = 28;  // decimals with a comma, and 64 bits in HDF5
    return {{name_ + ".csv", number * static_cast<double>(width_)}};
}

FileWork SeriesOutput::take(const Clock& clock) {
    std::vector<double> row(width_);
    row[0] = clock.time;
    source_->sample(clock, std::span(row).subspan(1));
    ++rows_;
    return {[this, row = std::move(row)] {
                if (csv_) csv_->append(row);
                if (hdf5_) hdf5_->append(row);
            },
            sizeof(double) * width_};
}

void SeriesOutput::transfer(Archive& archive) {
    source_->transfer(archive);
    archive.count("rows", rows_);
}

void SeriesOutput::sync() {
    if (csv_) csv_->sync();
}

void SeriesOutput::resume(const Clock& clock) {
    if (csv_ && rows_ > 0 && !isThere(csv_->path()))
        throw FileError(fmt::format(
            "{} is gone, of which the run had written {} rows: put the file back, or go on in "
            "another folder by --restart and --output",
            csv_->path().string(), rows_));
    const std::optional<std::int64_t> kept = csv_ ? csv_->resume(clock) : std::nullopt;
    if (kept && *kept < rows_)
        throw FileError(fmt::format(
            "{} has {} rows up to time {}, and the run had written {}: put the file back, or go on "
            "in another folder by --restart and --output",
            csv_->path().string(), *kept, clock.time, rows_));
    // None where the series begins anew, with other quantities.
    rows_ = kept.value_or(0);
    if (hdf5_) hdf5_->resume(clock);
}

}  // namespace sphinx::io
