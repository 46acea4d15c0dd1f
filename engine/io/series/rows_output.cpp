// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/rows_output.h"

#include "core/errors.h"
#include "core/types.h"

#include <cmath>

namespace sphinx::io {

/// The rows of a source as a source of their own: its values, or their means since the last row.
class RowsOutput::Rows final : public SeriesSource {
 public:
    Rows(std::unique_ptr<SeriesSource> source, std::string form)
        : source_(std::move(source)), form_(std::move(form)) {
        std::size_t width = 0;
        for (const SeriesQuantity& quantity : source_->quantities()) width += quantity.size();
        values_.resize(width);
        sum_.resize(width);
        duration_.resize(width);
    }

    const std::vector<SeriesQuantity>& quantities() const override { return source_->quantities(); }

    void add(const Clock& clock) {
        source_->sample(clock, values_);
        ++samples_;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            if (std::isnan(values_[k])) continue;
            sum_[k] += clock.dt * values_[k];
            duration_[k] += clock.dt;
        }
    }

    void sample(const Clock& clock, std::span<double> row) override {
        if (samples_ == 0) {
            source_->sample(clock, row);
            return;
        }
        for (std::size_t k = 0; k < row.size(); ++k) {
            row[k] = duration_[k] > 0 ? sum_[k] / duration_[k] : nan_value;
            sum_[k] = duration_[k] = 0;
        }
        samples_ = 0;
    }

    void transfer(Archive& archive) override {
        std::string form = form_ + ", " + std::to_string(sum_.size()) + " values";
        const std::string own = form;
        archive.value("form", form);
        if (form != own) return;
        source_->transfer(archive);
        archive.count("samples", samples_);
        if (samples_ == 0) return;
        const std::size_t width = values_.size();
        archive.value("sum", sum_);
        archive.value("duration", duration_);
        if (sum_.size() != width || duration_.size() != width)
            throw FileError("the means of an output have another number of values");
    }

 private:
    std::unique_ptr<SeriesSource> source_;
    std::string form_;
    std::vector<double> values_;
    // Since the last row:
    std::vector<double> sum_;       // value * time
    std::vector<double> duration_;  // time with a value
    std::int64_t samples_ = 0;
};

namespace {

std::optional<std::string> sampledLayer(const MeanParameters& mean) {
    return mean.average ? std::optional(mean.layer.text) : std::nullopt;
}

/// A mean over other steps than before the restart begins anew.
std::string formOf(const RowsParameters& parameters) {
    const std::optional<std::string> layer = sampledLayer(parameters.mean);
    if (!layer) return parameters.form;
    return (layer->empty() ? "mean of " : "mean over " + *layer + " of ") + parameters.form;
}

}  // namespace

RowsOutput::RowsOutput(SeriesParameters series, RowsParameters parameters,
                       std::unique_ptr<SeriesSource> source)
    : RowsOutput(std::move(series), io::sampledLayer(parameters.mean),
                 std::make_unique<Rows>(std::move(source), formOf(parameters))) {}

RowsOutput::RowsOutput(SeriesParameters series, std::optional<std::string> layer,
                       std::unique_ptr<Rows> rows)
    : layer_(std::move(layer)), rows_(rows.get()), series_(std::move(series), std::move(rows)) {}

RowsOutput::~RowsOutput() = default;

FileWork RowsOutput::take(const Clock& clock) { return series_.take(clock); }
void RowsOutput::sample(const Clock& clock) { rows_->add(clock); }
void RowsOutput::transfer(Archive& archive) { series_.transfer(archive); }
void RowsOutput::resume(const Clock& clock) { series_.resume(clock); }

template <int Dim>
std::unique_ptr<Output> makeRowsOutput(const input::Component& component,
                                       const OutputContext<Dim>& context, RowsParameters parameters,
                                       std::unique_ptr<SeriesSource> source) {
    SeriesParameters series;
    series.folder = context.folder;
    series.name = component.name;
    series.time_unit = context.units.text(unit::time);
    series.hdf5 = context.results;
    return std::make_unique<RowsOutput>(std::move(series), std::move(parameters),
                                        std::move(source));
}

template std::unique_ptr<Output> makeRowsOutput<2>(const input::Component&, const OutputContext<2>&,
                                                   RowsParameters, std::unique_ptr<SeriesSource>);
template std::unique_ptr<Output> makeRowsOutput<3>(const input::Component&, const OutputContext<3>&,
                                                   RowsParameters, std::unique_ptr<SeriesSource>);

}  // namespace sphinx::io
