// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/column_file.h"

#include "core/characters.h"
#include "input/expressions/decimal.h"
#include "input/tree/suggest.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::language {
namespace {

using Cells = std::vector<std::string_view>;

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string_view unquoted(std::string_view cell) {
    return cell.size() >= 2 && cell.front() == '"' && cell.back() == '"'
               ? cell.substr(1, cell.size() - 2)
               : cell;
}

char separatorOf(std::string_view line) {
    for (const char separator : {';', '\t', ','})
        if (line.find(separator) != std::string_view::npos) return separator;
    return ' ';
}

Cells cellsOf(std::string_view line, char separator) {
    Cells cells;
    if (separator != ' ') {
        for (;;) {
            const std::size_t end = line.find(separator);
            cells.push_back(unquoted(trimmed(line.substr(0, end))));
            if (end == std::string_view::npos) return cells;
            line.remove_prefix(end + 1);
        }
    }
    for (;;) {
        line = trimmed(line);
        if (line.empty()) return cells;
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        cells.push_back(unquoted(line.substr(0, end)));
        line.remove_prefix(end);
    }
}

bool isNumber(std::string_view cell) { return input::parseDecimal<double>(cell).has_value(); }

class ColumnReader {
 public:
    ColumnReader(const std::array<FileColumn, 2>& columns, std::optional<ColumnFileError>& error)
        : columns_(columns), error_(error) {}

    TwoColumns read(std::string_view text) {
        if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
        for (line_ = 1; !text.empty() && !error_; ++line_) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            readLine(text.substr(0, end));
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        return std::move(result_);
    }

 private:
    void fail(std::string message) { error_ = ColumnFileError{line_, std::move(message)}; }

    void readLine(std::string_view line) {
        const std::size_t hash = line.find('#');
        const std::string_view content = trimmed(line.substr(0, hash));
        if (content.empty()) {
            if (hash != std::string_view::npos && !begun_) comment_ = line.substr(hash + 1);
            return;
        }
        const bool first = !begun_;
        if (first) separator_ = separatorOf(content);
        begun_ = true;
        const Cells cells = cellsOf(content, separator_);
        if (first && !place(cells)) return;
        if (!error_) addRow(cells);
    }

    /// Finds the columns by the first line; true when that is a row already.
    bool place(const Cells& first) {
        const bool numbers = std::ranges::all_of(first, isNumber);
        // Above a row of numbers the names may stand in a comment.
        const Cells names = numbers ? cellsOf(comment_, separator_) : first;
        bool is_row = true;
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            const FileColumn& column = columns_[c];
            if (column.number > 0) {
                index_[c] = static_cast<std::size_t>(column.number) - 1;
                is_row = is_row && (index_[c] >= first.size() || isNumber(first[index_[c]]));
                continue;
            }
            is_row = is_row && numbers;
            const auto found = std::ranges::find(names, std::string_view(column.name));
            index_[c] = static_cast<std::size_t>(found - names.begin());
            if (found != names.end()) continue;
            if (numbers)
                return fail(
                           "no line of names is above the numbers: give 'column' as a "
                           "number, 1 is the first"),
                       false;
            const std::vector<std::string> known(names.begin(), names.end());
            return fail("there is no column '" + column.name + "'" +
                        input::didYouMean(column.name, known)),
                   false;
        }
        return is_row;
    }

    void addRow(const Cells& cells) {
        TwoColumns::Row row{{}, line_};
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            const std::string name = columns_[c].number > 0
                                         ? "column " + std::to_string(columns_[c].number)
                                         : "'" + columns_[c].name + "'";
            if (index_[c] >= cells.size() || cells[index_[c]].empty())
                return fail(name + " has no value");
            const auto value = input::parseDecimal<double>(cells[index_[c]]);
            if (!value)
                return fail(fmt::format("{} is '{}', not a number", name, cells[index_[c]]));
            row.numbers[c] = *value;
        }
        result_.rows.push_back(row);
    }

    const std::array<FileColumn, 2>& columns_;
    std::optional<ColumnFileError>& error_;
    TwoColumns result_;
    std::array<std::size_t, 2> index_{};
    std::string_view comment_;  // the last one above the first line
    char separator_ = ' ';
    bool begun_ = false;
    int line_ = 0;
};

}  // namespace

TwoColumns readTwoColumns(std::string_view text, const std::array<FileColumn, 2>& columns,
                          std::optional<ColumnFileError>& error) {
    return ColumnReader(columns, error).read(text);
}

}  // namespace sphinx::language
