// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/tables.h"

#include "case/language/column_file.h"
#include "core/errors.h"
#include "core/read_file.h"
#include "input/expressions/decimal.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <set>

namespace sphinx::language {
namespace {

using namespace input;

constexpr double largest_number = 1e100;

/// Reads one entry.
class TableReader {
 public:
    TableReader(const Node::Entry& entry, Reader& reader)
        : entry_(entry), reader_(reader), label_(reader, entry.key) {
        named_.name = entry.key;
        named_.place = entry.place;
    }

    /// nullptr when it is wrong.
    TablePointer read() {
        const Declaration& declaration = *reader_.registry.find(Kind::block, "tables");
        if (!checkNewName(entry_.key, entry_.place, reader_.diagnostics)) return nullptr;
        if (!readParameters(entry_.value, entry_.place, reader_, {{&declaration, &named_.block}}))
            return nullptr;
        TableBlock& block = named_.block;
        if (!readUnit(argument_, block.argument, "argument") ||
            !readUnit(value_, block.value, "value"))
            return nullptr;
        if (!(block.file ? readFile() : readRows())) return nullptr;
        if (rows_.size() < 2) return fail(sourceNode(), "a table needs at least two rows"), nullptr;
        for (std::size_t k = 0; k < rows_.size(); ++k)
            if (!checkRow(k)) return nullptr;
        if (!block.file) writeRows();
        return std::make_shared<const TabulatedFunction>(named_.name, columnOf(0, argument_),
                                                         columnOf(1, value_), block.interpolation,
                                                         block.outside, reader_.units);
    }

    NamedTable named() && { return std::move(named_); }

 private:
    struct Column {
        std::optional<Unit> unit;
        KnownDimension dimension;
    };
    struct Row {
        std::array<double, 2> numbers;
        std::string where;  ///< "paddle.csv:3: "
        const Node* node;
    };

    bool fail(const Node& node, std::string message) {
        return reader_.error(node, std::move(message));
    }
    /// What the rows come from.
    const Node& sourceNode() const {
        return *entry_.value.find(named_.block.file ? "file" : "rows");
    }

    bool readUnit(Column& column, const std::optional<ColumnBlock>& block, const char* key) {
        if (!block || !block->unit) return true;
        const Node& node = *entry_.value.find(key)->find("unit");
        column.unit = parseUnit(*block->unit);
        if (!column.unit)
            return fail(node, "'" + *block->unit + "' is not a unit" + suggestUnit(*block->unit));
        column.dimension = column.unit->dimension;
        return !reader_.units.none || column.unit->dimension == unit::none ||
               fail(node,
                    "the case has 'units: none', so that " + *block->unit + " means nothing here");
    }

    bool readFile() {
        const Node& node = sourceNode();
        const std::string name = shownFile(node);
        std::string text;
        try {
            text = sphinx::readFile(*named_.block.file);
        } catch (const FileError& e) {
            return fail(node, e.what());
        }
        std::optional<ColumnFileError> error;
        const TwoColumns file = readTwoColumns(
            text, {columnIn(named_.block.argument, 1), columnIn(named_.block.value, 2)}, error);
        if (error) return fail(node, fmt::format("{}:{}: {}", name, error->line, error->message));
        for (const TwoColumns::Row& row : file.rows)
            rows_.push_back(
                {{converted(row.numbers[0], argument_), converted(row.numbers[1], value_)},
                 fmt::format("{}:{}: ", name, row.line),
                 &node});
        return true;
    }

    static FileColumn columnIn(const std::optional<ColumnBlock>& block, int otherwise) {
        if (!block || !block->column) return {"", otherwise};
        const auto number = parseDecimal<int>(*block->column);
        return number && *number > 0 ? FileColumn{"", *number} : FileColumn{*block->column, 0};
    }

    double converted(double number, const Column& column) const {
        return column.unit ? reader_.units.convert(number, *column.unit) : number;
    }

    bool readRows() {
        const Node& node = sourceNode();
        bool good = true;
        for (std::size_t r = 0; r < node.items.size(); ++r) {
            const Node& row = node.items[r];
            const Label label(reader_, fmt::format("row {}", r + 1));
            if (!row.isList() || row.items.size() != 2) {
                good = fail(row, reader_.label + " must be a list of argument and value");
                continue;
            }
            const auto argument = readCell(row.items[0], argument_);
            const auto value = readCell(row.items[1], value_);
            good = good && argument && value;
            if (argument && value) rows_.push_back({{*argument, *value}, "", &row});
        }
        return good;
    }

    /// A bare number is in the unit of its column; anything else must say its own.
    std::optional<double> readCell(const Node& node, Column& column) {
        if (column.unit && node.isScalar())
            if (const auto number = parseDecimal<double>(node.text))
                return converted(*number, column);
        const auto value =
            reader_.scope.value(node, reader_.label, reader_.units, reader_.diagnostics);
        if (!value) return {};
        if (column.unit && !value->dimension)
            return fail(node, fmt::format("{}: '{}' has no unit of its own and is in case units: "
                                          "give it one, or leave out 'unit'",
                                          reader_.label, node.text)),
                   std::nullopt;
        if (value->dimension && column.dimension && *value->dimension != *column.dimension)
            return fail(node, fmt::format("{}: {} and {} do not go together", reader_.label,
                                          dimensionWords(*column.dimension),
                                          dimensionWords(*value->dimension))),
                   std::nullopt;
        if (value->dimension) column.dimension = value->dimension;
        return value->number;
    }

    bool checkRow(std::size_t k) {
        const Row& row = rows_[k];
        for (const double number : row.numbers)
            if (!(std::abs(number) <= largest_number))
                return fail(*row.node,
                            fmt::format("{}{:g} must be between -{:g} and {:g}", row.where, number,
                                        largest_number, largest_number));
        if (k == 0 || row.numbers[0] > rows_[k - 1].numbers[0]) return true;
        const std::string unit =
            argument_.dimension ? reader_.units.suffix(*argument_.dimension) : "";
        return fail(*row.node,
                    fmt::format("{}the argument is {}{} but must be above {}{}, that of "
                                "the row before",
                                row.where, row.numbers[0], unit, rows_[k - 1].numbers[0], unit));
    }

    TabulatedFunction::Column columnOf(std::size_t c, const Column& column) const {
        TabulatedFunction::Column result{{}, column.dimension};
        for (const Row& row : rows_) result.numbers.push_back(row.numbers[c]);
        return result;
    }

    /// The resolved case has the rows in case units.
    void writeRows() {
        Node& rows = named_.block.rows;
        for (std::size_t r = 0; r < rows_.size(); ++r)
            for (std::size_t c = 0; c < 2; ++c) {
                Node& cell = rows.items[r].items[c];
                cell = Node::number(rows_[r].numbers[c]).at(cell.place);
            }
        writeUnit(named_.block.argument, argument_);
        writeUnit(named_.block.value, value_);
    }
    void writeUnit(std::optional<ColumnBlock>& block, const Column& column) const {
        if (!column.dimension) return;
        const std::string text = reader_.units.text(*column.dimension);
        if (!block) block.emplace();
        block->unit = *column.dimension == unit::none ? "rad" : text;
    }

    const Node::Entry& entry_;
    Reader& reader_;
    Label label_;
    NamedTable named_;
    Column argument_, value_;
    std::vector<Row> rows_;
};

}  // namespace

void announceTables(const Node& root, Reader& reader, std::vector<NamedTable>& tables) {
    const Node* block = root.find("tables");
    if (!block || !block->isMap()) return;
    const auto read = [&reader, &tables](const Node::Entry& entry) {
        TableReader table(entry, reader);
        TablePointer function = table.read();
        tables.push_back(std::move(table).named());
        return function;
    };
    reader.scope.declareTables(*block, read, reader.diagnostics);
}

void checkTableTimes(const Reader& reader, const model::Loop& loop) {
    std::set<const TabulatedFunction*> reported;
    for (const auto& [table, place] : reader.scope.timedCalls()) {
        if (table->outside() == Outside::hold) continue;
        const double tiny = 1e-9 * (table->last() - table->first());
        if (table->first() <= loop.start_time + tiny && table->last() >= loop.end_time - tiny)
            continue;
        if (!reported.insert(table.get()).second) continue;
        const std::string unit = reader.units.suffix(unit::time);
        reader.diagnostics.error(
            place, fmt::format("{}, but the run goes from {:g}{} to {:g}{}; 'outside: hold' would "
                               "keep its first and last value",
                               table->rangeText(), loop.start_time, unit, loop.end_time, unit));
    }
}

}  // namespace sphinx::language
