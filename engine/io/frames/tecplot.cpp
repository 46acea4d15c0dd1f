// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/tecplot.h"

#include "core/parallel.h"
#include "io/file/number_text.h"

#include <algorithm>

namespace sphinx::io {
namespace {

constexpr std::size_t lines_in_block = 4096;  // formatted by one thread at a time

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

std::string formatLines(const std::vector<const particles::FieldBase*>& fields,
                        const particles::IdOrder& order, std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t k = begin; k < end; ++k) {
        const std::size_t i = order[k];
        for (const particles::FieldBase* field : fields) {
            const auto width = static_cast<std::size_t>(field->components());
            for (std::size_t c = 0; c < width; ++c) {
                if (const std::int64_t* integers = field->integers())
                    appendInteger(text, integers[i * width + c]);
                else
                    appendNumber(text, field->numbers()[i * width + c]);
                text += ' ';
            }
        }
        text.back() = '\n';
    }
    return text;
}

}  // namespace

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
void TecplotOutput<Dim>::write(const Clock& clock) {
    int strand = 0;
    for (const Series& series : series_) {
        ++strand;
        const particles::IdOrder order(series.body->particles);
        const std::size_t particles = order.size();
        if (particles == 0) continue;
        std::string header =
            "TITLE = " + quoted(series.body->name) + "\nVARIABLES =" + series.variables + "\n";
        for (const auto& [name, value] : parameters_.provenance.entries)
            header += "DATASETAUXDATA " + name + " = " + quoted(value) + "\n";
        header += "ZONE T = " + quoted(series.body->name) + ", I = " + std::to_string(particles) +
                  ", DATAPACKING = POINT, STRANDID = " + std::to_string(strand) +
                  ", SOLUTIONTIME = " + numberText(clock.time) + "\n";
        AtomicFile file(parameters_.folder / frameName(series.body->name, frames_, ".dat"));
        file.write(header);
        // A few blocks at a time, so that the text of a large frame is never held as a whole.
        std::vector<std::string> blocks(16);
        for (std::size_t begin = 0; begin < particles;) {
            const std::size_t end = std::min(particles, begin + blocks.size() * lines_in_block);
            parallelFor(
                blocks.size(),
                [&](std::size_t b) {
                    const std::size_t first = std::min(end, begin + b * lines_in_block);
                    blocks[b] = formatLines(series.fields, order, first,
                                            std::min(end, first + lines_in_block));
                },
                1);
            for (const std::string& block : blocks) file.write(block);
            begin = end;
        }
        file.commit();
    }
    ++frames_;
}

template <int Dim>
void TecplotOutput<Dim>::resume(const Clock&) {
    for (const Series& series : series_)
        removeFramesFrom(parameters_.folder, series.body->name, ".dat", frames_);
}

template class TecplotOutput<2>;
template class TecplotOutput<3>;

}  // namespace sphinx::io
