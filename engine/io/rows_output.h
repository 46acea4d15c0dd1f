// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/output_factory.h"
#include "io/series.h"

namespace sphinx::io {

struct RowsParameters {
    bool average = false;  ///< rows are means over time
    /// What the source's state means: a state saved under another form is not loaded, because
    /// outputs are free to change between a run and its resumption.
    std::string form;
};

/// A time series of a source. Its rows are the values at their instant or, with `average`, the
/// means of the values after every outermost step since the row before, each weighted by the length
/// of its step. Values that are NaN are left out of a mean; a mean of nothing is NaN. The first
/// row, before any step, holds the values themselves.
class RowsOutput final : public Output {
 public:
    RowsOutput(SeriesParameters series, RowsParameters parameters,
               std::unique_ptr<SeriesSource> source);
    ~RowsOutput() override;

    std::vector<OutputFile> files() const override { return series_.files(); }
    void write(const Clock& clock) override;
    bool samplesEveryStep() const override { return average_; }
    void sample(const Clock& clock) override;
    void transfer(Archive& archive) override;
    void resume(const Clock& clock) override;

 private:
    class Rows;
    RowsOutput(SeriesParameters series, bool average, std::unique_ptr<Rows> rows);

    bool average_;
    Rows* rows_;  // owned by the series
    SeriesOutput series_;
};

/// As above, with files named after the entry of the case.
template <int Dim>
std::unique_ptr<Output> makeRowsOutput(const input::Component& component,
                                       const OutputContext<Dim>& context, RowsParameters parameters,
                                       std::unique_ptr<SeriesSource> source);

}  // namespace sphinx::io
