// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/reader.h"
#include "input/types/type_support.h"

#include <fmt/format.h>

namespace sphinx::input {
namespace {

constexpr std::array axes{"x", "y", "z"};

/// Reports unless the node is a list with one item per dimension.
bool checkComponents(const Node& node, Reader& reader) {
    const std::string expected = reader.dimension == 3   ? "[x, y, z]"
                                 : reader.dimension == 2 ? "[x, y]"
                                                         : "[x, y] or [x, y, z]";
    if (!node.isList()) return reader.mismatch(node, expected);
    const std::size_t n = node.items.size();
    if (reader.dimension == 0 ? (n != 2 && n != 3)
                              : n != static_cast<std::size_t>(reader.dimension))
        return reader.error(
            node, fmt::format("{} has {} components but must be {}", reader.label, n, expected));
    return true;
}

Node componentsSchema() {
    Node schema = schemaType("array");
    schema.set("items", numberSchema());
    schema.set("minItems", Node::integer(2));
    schema.set("maxItems", Node::integer(3));
    return schema;
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
}  // namespace sphinx::input
