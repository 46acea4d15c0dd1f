// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "io/file/file.h"
#include "io/series/quantity.h"

#include <cstdint>
#include <optional>
#include <span>

namespace sphinx::io {

/// Time series as text: a header like `time [s],pressure [Pa],velocity_x [m/s]`, then a line for
/// each row with the shortest decimals that read back as the same numbers (nan where there is no
/// value). A line is written at once, so that the file can be watched and cut anywhere.
class CsvSeries {
 public:
    CsvSeries(const Path& path, const std::string& time_unit,
              const std::vector<SeriesQuantity>& quantities);

    /// row[0] is the time. The first call creates the file; throws FileError if it exists.
    void append(std::span<const double> row);
    /// The disk has all rows when it returns.
    void sync() {
        if (file_) file_->sync();
    }
    /// Goes on with an existing file: drops rows later than clock.time and a row cut short. Returns
    /// the number of rows that stay; nothing where there is no such file, or one of other
    /// quantities.
    std::optional<std::int64_t> resume(const Clock& clock);
    const Path& path() const { return path_; }

 private:
    Path path_;
    std::string header_;
    std::string line_;
    std::optional<File> file_;
};

}  // namespace sphinx::io
