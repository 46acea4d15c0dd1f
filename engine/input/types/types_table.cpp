// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/characters.h"
#include "core/errors.h"
#include "core/read_file.h"
#include "input/declaration/reader.h"
#include "input/expressions/decimal.h"
#include "input/types/type_support.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::input {
namespace {

class TableType final : public TypeBase {
 public:
    TableType(Dimension unit, std::optional<Dimension> last, bool reads_file)
        : unit_(unit), last_(last), reads_file_(reads_file) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& table = *static_cast<Table*>(out);
        table = {};
        if (node.isMap() && node.entries.size() == 1 && node.entries[0].key == "file")
            return readFromFile(node.entries[0].value, reader, table);
        if (!node.isList()) return reader.mismatch(node, "a list of rows [...] or {file: NAME}");
        const std::size_t columns = columnCount(reader);
        bool good = true;
        for (std::size_t r = 0; r < node.items.size(); ++r) {
            const Node& row = node.items[r];
            const Label label(reader, fmt::format("row {} of {}", r + 1, reader.label));
            if (!row.isList() || row.items.size() != columns) {
                good = reader.error(
                    row, fmt::format("{} must be a list of {} numbers", reader.label, columns));
                continue;
            }
            auto& numbers = table.rows.emplace_back();
            for (std::size_t k = 0; k < columns; ++k) {
                const bool is_last = last_ && k + 1 == columns;
                const auto value = reader.number(row.items[k], is_last ? *last_ : unit_);
                good = good && value;
                numbers.push_back(value.value_or(0));
            }
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        const auto& table = *static_cast<const Table*>(value);
        if (!table.file.empty()) {
            Node map = Node::map().at(placeOf(source));
            map.set("file", Node::string(table.file).at(placeOf(source)));
            return map;
        }
        Node list = Node::list().at(placeOf(source));
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            Node& row = list.add(Node::list().at(placeOf(itemOf(source, r))));
            for (double number : table.rows[r]) row.add(Node::number(number).at(row.place));
        }
        return list;
    }
    Node schema(SchemaBuilder& builder) const override {
        return builder.define("table", [] {
            Node row = schemaType("array");
            row.set("items", numberSchema());
            Node file = Node::map();
            file.set("file", schemaType("string"));
            Node schema = Node::map();
            schema.set("type", Node::list({Node::string("array"), Node::string("object")}));
            schema.set("items", std::move(row));
            schema.set("properties", std::move(file));
            schema.set("required", Node::list({Node::string("file")}));
            schema.set("additionalProperties", Node::plain("false"));
            return schema;
        });
    }
    std::string text() const override {
        return "rows of one number per dimension" + unitSuffix(unit_) +
               (last_ ? " and one more" + unitSuffix(*last_) : "") + ", or {file: NAME}";
    }

 private:
    std::size_t columnCount(const Reader& reader) const {
        return static_cast<std::size_t>(reader.dimension == 3 ? 3 : 2) + (last_ ? 1 : 0);
    }

    bool readFromFile(const Node& node, Reader& reader, Table& table) const {
        const Label label(reader, "file");
        if (!file().base()->read(node, reader, &table.file)) return false;
        if (!reads_file_) return true;
        std::string text;
        try {
            text = readFile(table.file);
        } catch (const FileError& e) {
            return reader.error(node, e.what());
        }
        const std::size_t columns = columnCount(reader);
        const std::string name = shownFile(node);
        std::string_view rest = text;
        if (rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
        for (int line = 1; !rest.empty(); ++line) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            std::string_view row = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            row = row.substr(0, row.find('#'));
            std::vector<double> numbers;
            while (!row.empty()) {
                const std::size_t begin = row.find_first_not_of(" \t\r,;");
                if (begin == std::string_view::npos) break;
                const std::size_t stop = std::min(row.find_first_of(" \t\r,;", begin), row.size());
                const auto value = parseDecimal<double>(row.substr(begin, stop - begin));
                if (!value)
                    return reader.error(node, fmt::format("{}:{}: '{}' is not a number", name, line,
                                                          row.substr(begin, stop - begin)));
                numbers.push_back(*value);
                row.remove_prefix(stop);
            }
            if (numbers.empty()) continue;
            if (numbers.size() != columns)
                return reader.error(node, fmt::format("{}:{}: {} numbers where {} are expected",
                                                      name, line, numbers.size(), columns));
            table.rows.push_back(std::move(numbers));
        }
        return true;
    }

    Dimension unit_;
    std::optional<Dimension> last_;
    bool reads_file_;
};

}  // namespace

Type<Table> table(Dimension unit) {
    return Type<Table>(std::make_shared<TableType>(unit, std::nullopt, true));
}
Type<Table> table(Dimension unit, Dimension last) {
    return Type<Table>(std::make_shared<TableType>(unit, last, true));
}
Type<Table> tableOrFile(Dimension unit) {
    return Type<Table>(std::make_shared<TableType>(unit, std::nullopt, false));
}

}  // namespace sphinx::input
