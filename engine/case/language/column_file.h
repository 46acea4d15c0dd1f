// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sphinx::language {

/// A column of a text file: by its name in the line above the numbers, or by its number.
struct FileColumn {
    std::string name;
    int number = 0;  ///< 1 is the first; 0: by its name
};

/// The numbers of two columns, row by row.
struct TwoColumns {
    struct Row {
        std::array<double, 2> numbers;
        int line;  ///< in the file; 1 is the first
    };
    std::vector<Row> rows;
};

struct ColumnFileError {
    int line;
    std::string message;
};

/// Reads lines of cells that semicolons, tabs, commas or blanks separate: the first of these that
/// the first line has. # starts a comment. A line of names may stand above the numbers, also as a
/// comment. Other columns than the two may hold anything.
TwoColumns readTwoColumns(std::string_view text, const std::array<FileColumn, 2>& columns,
                          std::optional<ColumnFileError>& error);

}  // namespace sphinx::language
