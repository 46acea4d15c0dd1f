// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/tables.h"
#include "input/declaration/schema.h"

#include <algorithm>

namespace sphinx::language {
namespace {

using namespace input;

/// Rows of argument and value, as they are written: what reads the table knows their units.
class TableRowsType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isList()) return reader.mismatch(node, "a list of rows [argument, value]");
        *static_cast<Node*>(out) = node;
        return true;
    }
    Node write(const void* value, const Node*) const override {
        return *static_cast<const Node*>(value);
    }
    Node schema(SchemaBuilder&) const override {
        Node number = Node::map();
        number.set("type", Node::list({Node::string("number"), Node::string("string")}));
        Node row = schemaType("array");
        row.set("items", std::move(number));
        row.set("minItems", Node::integer(2));
        row.set("maxItems", Node::integer(2));
        Node schema = schemaType("array");
        schema.set("items", std::move(row));
        schema.set("minItems", Node::integer(2));
        return schema;
    }
    std::string text() const override { return "rows of argument and value"; }
    bool absent(const void* value) const override {
        return static_cast<const Node*>(value)->isNull();
    }
};

class NamedTablesType final : public TypeBase {
 public:
    explicit NamedTablesType(const Declaration& table) : table_(table) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isMap()) return reader.mismatch(node, "a map from names to tables");
        bool good = true;
        for (const Node::Entry& entry : node.entries)
            good = reader.scope.hasTable(entry.key) &&
                   reader.scope.table(entry.key, entry.place, reader.diagnostics, false) && good;
        // Variables may have needed them in another order.
        const auto place = [&](const NamedTable& table) {
            return std::ranges::find(node.entries, table.name, &Node::Entry::key);
        };
        std::ranges::sort(*static_cast<std::vector<NamedTable>*>(out), {}, place);
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        Node map = Node::map();
        for (const NamedTable& table : *static_cast<const std::vector<NamedTable>*>(value)) {
            Node one = Node::map().at(table.place);
            writeParameters(table_, &table.block, source ? source->find(table.name) : nullptr, one);
            map.set(table.name, std::move(one));
        }
        return map;
    }
    Node schema(SchemaBuilder& builder) const override {
        Node schema = schemaType("object");
        schema.set("additionalProperties",
                   builder.define("table_function", [&] { return builder.object(table_); }));
        return schema;
    }
    std::string text() const override { return "map from names to tables, see 'tables'"; }
    bool absent(const void* value) const override {
        return static_cast<const std::vector<NamedTable>*>(value)->empty();
    }

 private:
    const Declaration& table_;
};

}  // namespace

Type<std::vector<NamedTable>> namedTables(const Declaration& table) {
    return Type<std::vector<NamedTable>>(std::make_shared<NamedTablesType>(table));
}

void declareTables(Registry& registry) {
    {
        using P = ColumnBlock;
        auto& d = registry.declare<P>(Kind::block, "tables.column");
        d.summary("What the arguments or the values of a table are");
        d.optional("column", &P::column, text(),
                   "in the file: the name above the numbers, or the number, 1 is the first; "
                   "default: 1 of the argument, 2 of the value");
        d.optional("unit", &P::unit, text(),
                   "of bare numbers; expressions that use the table are checked with it; default: "
                   "that of the case, and it fits anything");
    }
    using P = TableBlock;
    auto& d = registry.declare<P>(Kind::block, "tables");
    d.summary("One entry of tables: a function of one argument that expressions call by its name");
    d.formula(
        "paddle(t), profile(y). A file has one row a line; semicolons, tabs, commas or blanks "
        "separate the cells, # starts a comment, a line of names may stand above the numbers");
    d.optional("file", &P::file, file(), "where the rows stand");
    d.optional("rows", &P::rows, Type<Node>(std::make_shared<TableRowsType>()),
               "the rows themselves, [argument, value], instead of a file: numbers, quantities or "
               "expressions of variables");
    const Declaration& column = *registry.find(Kind::block, "tables.column");
    d.optional("argument", &P::argument, structure<ColumnBlock>(column),
               "of the arguments, which increase from row to row");
    d.optional("value", &P::value, structure<ColumnBlock>(column), "of the values");
    d.optional("interpolation", &P::interpolation,
               choice<Interpolation>(
                   {{"linear", Interpolation::linear, "straight between the rows"},
                    {"cubic", Interpolation::cubic,
                     "natural cubic spline: velocity and acceleration of a motion are continuous, "
                     "and there is no acceleration at the ends"}}),
               "between the rows");
    d.optional("outside", &P::outside,
               choice<Outside>({{"error", Outside::error,
                                 "an error; of a table of time already before the run"},
                                {"hold", Outside::hold, "the first or the last value"}}),
               "before the first and after the last row");
    d.check("", [](const P& p) -> std::string {
        return p.file.has_value() == p.rows.isNull() ? "" : "a table has either 'file' or 'rows'";
    });
    d.check("", [](const P& p) -> std::string {
        const auto of_file = [](const auto& block) { return block && block->column; };
        return !p.file && (of_file(p.argument) || of_file(p.value))
                   ? "'column' is for a file: a row of 'rows' has its argument first"
                   : "";
    });
}

}  // namespace sphinx::language
