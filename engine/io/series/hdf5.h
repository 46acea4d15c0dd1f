// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clock.h"
#include "io/hdf5/results_file.h"
#include "io/series/quantity.h"

#include <memory>
#include <span>

namespace sphinx::io {

/// Time series in results.h5: series/NAME/time and one dataset for each quantity, [rows] or
/// [rows x labels], with the attributes unit, description and labels.
class Hdf5Series {
 public:
    Hdf5Series(std::shared_ptr<ResultsFile> file, const std::string& name,
               const std::string& time_unit, const std::vector<SeriesQuantity>& quantities);

    /// row[0] is the time. The row is in the file when this returns.
    void append(std::span<const double> row);
    /// Goes on with the series in the file: drops rows later than clock.time.
    void resume(const Clock& clock);

 private:
    void open();

    struct Column {
        std::string name;
        std::size_t width = 1;
        std::shared_ptr<hdf5::ChunkedArray> array;
    };

    std::shared_ptr<ResultsFile> file_;
    std::string name_;
    std::shared_ptr<hdf5::Group> group_;
    std::vector<Column> columns_;  // time first
    bool open_ = false;
};

}  // namespace sphinx::io
