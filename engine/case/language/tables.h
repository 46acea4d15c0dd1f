// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The block `tables`: functions of one argument for expressions.

#include "case/model/model.h"
#include "input/declaration/reader.h"
#include "input/types/type.h"

namespace sphinx::language {

/// A column as an entry of `tables` tells of it.
struct ColumnBlock {
    std::optional<std::string> column;  ///< its name or number in the file
    std::optional<std::string> unit;    ///< of bare numbers; without: case units
};

struct TableBlock {
    std::optional<std::string> file;  ///< absolute
    input::Node rows;                 ///< once read: numbers in case units
    std::optional<ColumnBlock> argument, value;
    input::Interpolation interpolation = input::Interpolation::linear;
    input::Outside outside = input::Outside::error;
};

/// An entry of `tables`.
struct NamedTable {
    std::string name;
    input::Place place;
    TableBlock block;
};

void declareTables(input::Registry& registry);

/// Tells the reader's scope the names of the tables of a case, which it reads into `tables` when
/// they are needed. Both must outlive the reading of the case.
void announceTables(const input::Node& root, input::Reader& reader,
                    std::vector<NamedTable>& tables);

/// The block itself: reads what nothing has needed so far.
input::Type<std::vector<NamedTable>> namedTables(const input::Declaration& table);

/// Reports tables that are asked for times of the run that they do not have.
void checkTableTimes(const input::Reader& reader, const model::Loop& loop);

}  // namespace sphinx::language
