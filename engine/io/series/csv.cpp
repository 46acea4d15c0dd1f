// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/series/csv.h"

#include "core/errors.h"
#include "io/file/number_text.h"

#include <charconv>

namespace sphinx::io {
namespace {

void appendCell(std::string& line, const std::string& name, const std::string& unit) {
    const std::string cell = unit.empty() ? name : name + " [" + unit + "]";
    if (!line.empty()) line += ',';
    if (cell.find_first_of(",\"\n") == cell.npos) {
        line += cell;
        return;
    }
    line += '"';
    for (const char c : cell) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
}

/// Reads line after line without holding the file in memory.
class LineReader {
 public:
    explicit LineReader(const Path& path) : file_(File::openRead(path)) {}

    /// False at the end, also for a last line without line end.
    bool next(std::string& line) {
        line.clear();
        for (;;) {
            const std::size_t end = buffer_.find('\n', position_);
            if (end != buffer_.npos) {
                line.append(buffer_, position_, end - position_);
                position_ = end + 1;
                offset_ += line.size() + 1;
                return true;
            }
            line.append(buffer_, position_);
            position_ = 0;
            buffer_.resize(65536);
            buffer_.resize(file_.read(buffer_.data(), buffer_.size()));
            if (buffer_.empty()) return false;
        }
    }
    /// Of the end of the last complete line.
    std::uint64_t offset() const { return offset_; }

 private:
    File file_;
    std::string buffer_;
    std::size_t position_ = 0;
    std::uint64_t offset_ = 0;
};

}  // namespace

CsvSeries::CsvSeries(const Path& path, const std::string& time_unit,
                     const std::vector<SeriesQuantity>& quantities)
    : path_(path) {
    appendCell(header_, "time", time_unit);
    for (const SeriesQuantity& quantity : quantities) {
        if (quantity.labels.empty()) appendCell(header_, quantity.name, quantity.unit);
        for (const std::string& label : quantity.labels)
            appendCell(header_, quantity.name + "_" + label, quantity.unit);
    }
}

void CsvSeries::append(std::span<const double> row) {
    if (!file_) {
        if (isThere(path_))
            throw FileError("cannot write " + path_.string() + ": it exists already");
        file_ = File::openAppend(path_);
        file_->write(header_ + "\n");
    }
    line_.clear();
    for (const double value : row) {
        if (!line_.empty()) line_ += ',';
        appendNumber(line_, value);
    }
    line_ += '\n';
    file_->write(line_);
}

std::optional<std::int64_t> CsvSeries::resume(const Clock& clock) {
    if (!isThere(path_)) return {};
    std::int64_t rows = 0;
    LineReader reader(path_);
    std::string line;
    std::uint64_t keep = 0;
    if (reader.next(line)) {
        if (line != header_) {
            setAside(path_, clock.steps);
            return {};
        }
        keep = reader.offset();
        while (reader.next(line)) {
            double time = 0;
            const char* end = line.data() + line.size();
            const auto result = std::from_chars(line.data(), end, time);
            if (result.ec != std::errc() || (result.ptr != end && *result.ptr != ','))
                throw FileError("cannot continue " + path_.string() + ": \"" + line.substr(0, 40) +
                                "\" is not a row that sphinx wrote");
            if (time > clock.time) break;
            keep = reader.offset();
            ++rows;
        }
    }
    File::openUpdate(path_).truncate(keep);
    file_ = File::openAppend(path_);
    if (keep == 0) file_->write(header_ + "\n");
    return rows;
}

}  // namespace sphinx::io
