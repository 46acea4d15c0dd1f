// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/archive.h"
#include "core/clock.h"
#include "core/output.h"
#include "io/hdf5/results_file.h"
#include "io/series/csv.h"
#include "io/series/hdf5.h"
#include "io/series/quantity.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sphinx::io {

/// Whatever yields a row of numbers at an instant: an observer, a reduction.
class SeriesSource {
 public:
    virtual ~SeriesSource() = default;
    /// What the rows hold; does not change during a run.
    virtual const std::vector<SeriesQuantity>& quantities() const = 0;
    /// Fills in one row: the values of all quantities, one behind the other.
    virtual void sample(const Clock& clock, std::span<double> row) = 0;
    /// State that a restart must carry (running means).
    virtual void transfer(Archive&) {}
};

struct SeriesParameters {
    Path folder;
    std::string name;       ///< as in the case: NAME.csv, series/NAME in results.h5
    std::string time_unit;  ///< empty: none
    bool csv = true;
    std::shared_ptr<ResultsFile> hdf5;  ///< null: not written there
};

/// A time series, one row a write, as CSV and in results.h5. After a restart the rows later than
/// the resumed time are dropped; where some are missing before it, that is a FileError. If the
/// quantities changed, the old series is kept beside the new one under a name with ".before_STEP".
class SeriesOutput final : public Output {
 public:
    SeriesOutput(SeriesParameters parameters, std::unique_ptr<SeriesSource> source);

    std::vector<OutputFile> files() const override;
    FileWork take(const Clock& clock) override;
    void sync() override;
    void transfer(Archive& archive) override;
    void resume(const Clock& clock) override;
    void leave() override { rows_ = 0; }

 private:
    std::string name_;
    std::unique_ptr<SeriesSource> source_;
    std::optional<CsvSeries> csv_;
    std::optional<Hdf5Series> hdf5_;
    std::size_t width_ = 1;  // of a row, time first
    std::int64_t rows_ = 0;  // taken since the series began
};

}  // namespace sphinx::io
