// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/series.h"

namespace sphinx::io {

SeriesOutput::SeriesOutput(SeriesParameters parameters, std::unique_ptr<SeriesSource> source)
    : name_(parameters.name), source_(std::move(source)) {
    const std::vector<SeriesQuantity>& quantities = source_->quantities();
    std::size_t width = 1;
    for (const SeriesQuantity& quantity : quantities) width += quantity.size();
    row_.resize(width);
    if (parameters.csv)
        csv_.emplace(parameters.folder / (parameters.name + ".csv"), parameters.time_unit,
                     quantities);
    if (parameters.hdf5)
        hdf5_.emplace(parameters.hdf5, parameters.name, parameters.time_unit, quantities);
}

std::vector<OutputFile> SeriesOutput::files() const {
    constexpr double number = 28;  // decimals with a comma, and 64 bits in HDF5
    return {{name_ + ".csv", number * static_cast<double>(row_.size())}};
}

void SeriesOutput::write(const Clock& clock) {
    row_[0] = clock.time;
    source_->sample(clock, std::span(row_).subspan(1));
    if (csv_) csv_->append(row_);
    if (hdf5_) hdf5_->append(row_);
}

void SeriesOutput::resume(const Clock& clock) {
    if (csv_) csv_->resume(clock);
    if (hdf5_) hdf5_->resume(clock);
}

}  // namespace sphinx::io
