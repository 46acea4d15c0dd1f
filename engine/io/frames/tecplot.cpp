// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/tecplot.h"

#include "io/file/number_text.h"

#include <algorithm>
#include <memory>

namespace sphinx::io {
namespace {

constexpr std::size_t lines_in_block = 4096;

std::string quoted(std::string text) {
    std::replace(text.begin(), text.end(), '"', '\'');
    std::replace(text.begin(), text.end(), '\n', ' ');
    return "\"" + text + "\"";
}

/// Names of the components of a field: velocity_x, stress_xy.
template <int Dim>
std::vector<std::string> componentNames(const particles::FieldInfo& info) {
    const std::string name(info.name);
    const std::string axes = "xyz";
    std::vector<std::string> names;
    if (info.name == fields::position.name)
        for (int k = 0; k < Dim; ++k) names.emplace_back(1, axes[k]);
    else if (info.rank == particles::Rank::vector)
        for (int k = 0; k < Dim; ++k) names.push_back(name + "_" + axes[k]);
    else if (info.rank == particles::Rank::matrix)  // column by column, as in memory
        for (int column = 0; column < Dim; ++column)
            for (int row = 0; row < Dim; ++row)
                names.push_back(name + "_" + axes[row] + axes[column]);
    else
        names.push_back(name);
    return names;
}

/// The values of a field, 8 bytes each, particles by ascending id.
struct Column {
    bool integers;
    std::size_t width;
    AlignedVector<char> values;

    void append(std::string& text, std::size_t k) const {
        for (std::size_t c = width * k; c < width * (k + 1); ++c) {
            if (integers)
                appendInteger(text, reinterpret_cast<const std::int64_t*>(values.data())[c]);
            else
                appendNumber(text, reinterpret_cast<const double*>(values.data())[c]);
            text += ' ';
        }
    }
};

std::string formatLines(const std::vector<Column>& columns, std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t k = begin; k < end; ++k) {
        for (const Column& column : columns) column.append(text, k);
        text.back() = '\n';
    }
    return text;
}

}  // namespace

template <int Dim>
struct TecplotOutput<Dim>::Frame {
    std::size_t particles = 0;
    std::vector<Column> columns;  // of all fields
};

template <int Dim>
TecplotOutput<Dim>::TecplotOutput(FrameParameters parameters,
                                  const std::vector<BodyFrames<Dim>>& bodies)
    : parameters_(std::move(parameters)) {
    for (const BodyFrames<Dim>& frames : bodies) {
        Series series;
        series.body = frames.body;
        series.fields = frameFields(frames);
        series.fields.insert(series.fields.begin(),
                             frames.body->particles.find(fields::position.name));
        for (const particles::FieldBase* field : series.fields) {
            const std::string unit = parameters_.units.text(field->info().unit);
            for (const std::string& name : componentNames<Dim>(field->info()))
                series.variables += " " + quoted(unit.empty() ? name : name + " [" + unit + "]");
        }
        series_.push_back(std::move(series));
    }
}

template <int Dim>
std::vector<OutputFile> TecplotOutput<Dim>::files() const {
    constexpr double number = 20;  // decimals and the blank behind them
    std::vector<OutputFile> files;
    for (const Series& series : series_)
        files.push_back(
            {series.body->name + "_*.dat",
             number * componentsOf(series.fields) * static_cast<double>(series.body->size())});
    return files;
}

template <int Dim>
FileWork TecplotOutput<Dim>::take(const Clock& clock) {
    auto frames = std::make_shared<std::vector<Frame>>();
    std::size_t bytes = 0;
    for (const Series& series : series_) {
        Frame& frame = frames->emplace_back();
        const particles::IdOrder order(series.body->particles);
        frame.particles = order.size();
        for (const particles::FieldBase* field : series.fields) {
            frame.columns.push_back({field->integers() != nullptr,
                                     static_cast<std::size_t>(field->components()),
                                     order.copy(*field)});
            bytes += frame.columns.back().values.size();
        }
    }
    return {[this, frames, time = clock.time, number = frames_++] {
                writeFrames(*frames, time, number);
            },
            bytes};
}

template <int Dim>
void TecplotOutput<Dim>::writeFrames(const std::vector<Frame>& frames, double time,
                                     std::int64_t number) {
    for (std::size_t s = 0; s < series_.size(); ++s) {
        const std::string& body = series_[s].body->name;
        const std::size_t particles = frames[s].particles;
        if (particles == 0) continue;
        std::string header =
            "TITLE = " + quoted(body) + "\nVARIABLES =" + series_[s].variables + "\n";
        for (const auto& [name, value] : parameters_.provenance.entries)
            header += "DATASETAUXDATA " + name + " = " + quoted(value) + "\n";
        header += "ZONE T = " + quoted(body) + ", I = " + std::to_string(particles) +
                  ", DATAPACKING = POINT, STRANDID = " + std::to_string(s + 1) +
                  ", SOLUTIONTIME = " + numberText(time) + "\n";
        const Path path = parameters_.folder / frameName(body, number, ".dat");
        AtomicFile file(path);
        file.write(header);
        // Block by block, so that the text of a large frame is never held as a whole.
        for (std::size_t begin = 0; begin < particles; begin += lines_in_block)
            file.write(
                formatLines(frames[s].columns, begin, std::min(particles, begin + lines_in_block)));
        file.publish();
        unsynced_.add(path);
    }
}

template <int Dim>
void TecplotOutput<Dim>::resume(const Clock&) {
    for (const Series& series : series_)
        removeFramesFrom(parameters_.folder, series.body->name, ".dat", frames_);
}

template class TecplotOutput<2>;
template class TecplotOutput<3>;

}  // namespace sphinx::io
