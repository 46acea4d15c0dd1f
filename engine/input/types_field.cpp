// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/decimal.h"
#include "input/load.h"
#include "input/reader.h"
#include "input/schema.h"

#include "core/errors.h"

#include <fmt/format.h>

namespace sphinx::input {
namespace {

constexpr std::array axes{"x", "y", "z"};

Place placeOf(const Node* source) { return source ? source->place : Place{}; }

const Node* itemOf(const Node* source, std::size_t k) {
    return source && source->isList() && k < source->items.size() ? &source->items[k] : source;
}

/// Reports unless the node is a list with one item per dimension.
bool checkComponents(const Node& node, Reader& reader) {
    const std::string expected = reader.dimension == 3   ? "[x, y, z]"
                                 : reader.dimension == 2 ? "[x, y]"
                                                         : "[x, y] or [x, y, z]";
    if (!node.isList())
        return reader.error(
            node, reader.label + " is " + describeNode(node) + " but must be " + expected);
    const std::size_t n = node.items.size();
    if (reader.dimension == 0 ? (n != 2 && n != 3)
                              : n != static_cast<std::size_t>(reader.dimension))
        return reader.error(
            node, fmt::format("{} has {} components but must be {}", reader.label, n, expected));
    return true;
}

Node numberSchema() {
    Node schema = Node::map();
    schema.set("type", Node::list({Node::string("number"), Node::string("string")}));
    return schema;
}

Node componentsSchema() {
    Node schema = schemaType("array");
    schema.set("items", numberSchema());
    schema.set("minItems", Node::integer(2));
    schema.set("maxItems", Node::integer(3));
    return schema;
}

std::string unitSuffix(Dimension unit) {
    return unit == unit::none ? "" : ", " + dimensionText(unit);
}

class CoordinatesType final : public TypeBase {
 public:
    explicit CoordinatesType(Dimension unit) : unit_(unit) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!checkComponents(node, reader)) return false;
        auto& result = *static_cast<Coordinates*>(out);
        result = {};
        result.size = static_cast<int>(node.items.size());
        bool good = true;
        for (std::size_t k = 0; k < node.items.size(); ++k) {
            const Label label(reader, fmt::format("{} of {}", axes[k], reader.label));
            const auto value = reader.number(node.items[k], unit_);
            good = good && value;
            if (value) result.values[k] = *value;
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        const auto& coordinates = *static_cast<const Coordinates*>(value);
        Node list = Node::list().at(placeOf(source));
        for (int k = 0; k < coordinates.size; ++k)
            list.add(Node::number(coordinates.values[k]).at(placeOf(itemOf(source, k))));
        return list;
    }
    Node schema(SchemaBuilder&) const override { return componentsSchema(); }
    std::string text() const override { return "one number per dimension" + unitSuffix(unit_); }
    bool absent(const void* value) const override {
        return static_cast<const Coordinates*>(value)->size == 0;
    }

 private:
    Dimension unit_;
};

bool readField(const Node& node, Reader& reader, Dimension unit, FieldExpression& out) {
    auto value = reader.scope.field(node, unit, reader.label, reader.units, reader.dimension,
                                    reader.diagnostics);
    if (value) out = std::move(*value);
    return value.has_value();
}

Node writeField(const FieldExpression& field, const Node* source) {
    return (field.constant() ? Node::number(field.value()) : Node::plain(field.text()))
        .at(placeOf(source));
}

class FieldType final : public TypeBase {
 public:
    explicit FieldType(Dimension unit) : unit_(unit) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        return readField(node, reader, unit_, *static_cast<FieldExpression*>(out));
    }
    Node write(const void* value, const Node* source) const override {
        return writeField(*static_cast<const FieldExpression*>(value), source);
    }
    Node schema(SchemaBuilder&) const override { return numberSchema(); }
    std::string text() const override {
        return "number or expression of x, y, z, t" + unitSuffix(unit_);
    }

 private:
    Dimension unit_;
};

class FieldVectorType final : public TypeBase {
 public:
    explicit FieldVectorType(Dimension unit) : unit_(unit) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!checkComponents(node, reader)) return false;
        auto& fields = *static_cast<std::vector<FieldExpression>*>(out);
        fields.assign(node.items.size(), {});
        bool good = true;
        for (std::size_t k = 0; k < node.items.size(); ++k) {
            const Label label(reader, fmt::format("{} of {}", axes[k], reader.label));
            good = readField(node.items[k], reader, unit_, fields[k]) && good;
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        Node list = Node::list().at(placeOf(source));
        const auto& fields = *static_cast<const std::vector<FieldExpression>*>(value);
        for (std::size_t k = 0; k < fields.size(); ++k)
            list.add(writeField(fields[k], itemOf(source, k)));
        return list;
    }
    Node schema(SchemaBuilder&) const override { return componentsSchema(); }
    std::string text() const override {
        return "one number or expression of x, y, z, t per dimension" + unitSuffix(unit_);
    }
    bool absent(const void* value) const override {
        return static_cast<const std::vector<FieldExpression>*>(value)->empty();
    }

 private:
    Dimension unit_;
};

class TableType final : public TypeBase {
 public:
    TableType(Dimension unit, std::optional<Dimension> last, bool reads_file)
        : unit_(unit), last_(last), reads_file_(reads_file) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& table = *static_cast<Table*>(out);
        table = {};
        if (node.isMap() && node.entries.size() == 1 && node.entries[0].key == "file")
            return readFromFile(node.entries[0].value, reader, table);
        if (!node.isList())
            return reader.error(node, reader.label + " is " + describeNode(node) +
                                          " but must be a list of rows [...] or {file: NAME}");
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
        std::string_view rest = text;
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
                    return reader.error(node, fmt::format("{}:{}: '{}' is not a number", table.file,
                                                          line, row.substr(begin, stop - begin)));
                numbers.push_back(*value);
                row.remove_prefix(stop);
            }
            if (numbers.empty()) continue;
            if (numbers.size() != columns)
                return reader.error(node, fmt::format("{}:{}: {} numbers where {} are expected",
                                                      table.file, line, numbers.size(), columns));
            table.rows.push_back(std::move(numbers));
        }
        return true;
    }

    Dimension unit_;
    std::optional<Dimension> last_;
    bool reads_file_;
};

}  // namespace

Type<Coordinates> coordinates(Dimension unit) {
    return Type<Coordinates>(std::make_shared<CoordinatesType>(unit));
}
Type<FieldExpression> fieldExpression(Dimension unit) {
    return Type<FieldExpression>(std::make_shared<FieldType>(unit));
}
Type<std::vector<FieldExpression>> fieldVector(Dimension unit) {
    return Type<std::vector<FieldExpression>>(std::make_shared<FieldVectorType>(unit));
}
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
