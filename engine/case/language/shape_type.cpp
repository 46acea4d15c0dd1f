// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/shapes.h"

#include "input/declaration/reader.h"
#include "input/declaration/schema.h"
#include "input/tree/suggest.h"

namespace sphinx::language {
namespace {

using namespace input;

class ShapeType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto shape = std::make_shared<ShapeExpression>();
        shape->place = node.place;
        if (node.isScalar()) {
            const bool good = shapeReference().base()->read(node, reader, &shape->reference);
            *static_cast<SharedShapeExpression*>(out) = std::move(shape);
            return good;
        }
        if (!node.isMap() || node.entries.size() != 1)
            return reader.error(
                node,
                reader.label + " is " +
                    (node.isMap() ? "a map with " + std::to_string(node.entries.size()) + " keys"
                                  : describeNode(node)) +
                    " but must be the name of a shape or a map with one key, such as "
                    "{box: {lower: ..., upper: ...}}");
        const Node::Entry& entry = node.entries.front();
        shape->place = entry.place;
        shape->declaration = reader.registry.find(Kind::shape, entry.key);
        if (!shape->declaration)
            return reader.error(entry.place,
                                "there is no shape '" + entry.key + "'" +
                                    didYouMean(entry.key, reader.registry.names(Kind::shape)));
        const Label label(reader, entry.key);
        std::shared_ptr<void> parameters = shape->declaration->makeParameters();
        const bool good = readParameters(entry.value, entry.place, reader,
                                         {{shape->declaration, parameters.get()}});
        shape->parameters = std::move(parameters);
        *static_cast<SharedShapeExpression*>(out) = std::move(shape);
        return good;
    }

    Node write(const void* value, const Node* source) const override {
        const ShapeExpression& shape = **static_cast<const SharedShapeExpression*>(value);
        if (!shape.declaration) return Node::plain(shape.reference.text).at(shape.place);
        Node map = Node::map().at(shape.place);
        const std::string& name = shape.declaration->name();
        map.set(name, writeStructure(*shape.declaration, shape.parameters.get(),
                                     source ? source->find(name) : nullptr));
        return map;
    }

    Node schema(SchemaBuilder& builder) const override {
        return builder.define("shape", [&] {
            Node schema = Node::map();
            schema.set("type", Node::list({Node::string("string"), Node::string("object")}));
            schema.set("description", Node::string("the name of a shape, or one of these"));
            schema.set("minProperties", Node::integer(1));
            schema.set("maxProperties", Node::integer(1));
            Node properties = Node::map();
            for (const std::string& name : builder.registry.names(Kind::shape))
                properties.set(name, builder.object(*builder.registry.find(Kind::shape, name)));
            schema.set("properties", std::move(properties));
            schema.set("additionalProperties", Node::plain("false"));
            return schema;
        });
    }
    std::string text() const override { return "shape or name of a shape"; }
    bool absent(const void* value) const override {
        return !*static_cast<const SharedShapeExpression*>(value);
    }
};

class NamedShapesType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isMap()) return reader.mismatch(node, "a map from names to shapes");
        auto& shapes = *static_cast<std::vector<NamedShape>*>(out);
        bool good = true;
        for (const Node::Entry& entry : node.entries) {
            NamedShape shape{entry.key, entry.place, nullptr};
            const Label label(reader, entry.key);
            good = checkNewName(entry.key, entry.place, reader.diagnostics) && good;
            SharedShapeExpression expression;
            good = type_.base()->read(entry.value, reader, &expression) && good;
            shape.expression = std::move(expression);
            shapes.push_back(std::move(shape));
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        Node map = Node::map();
        for (const NamedShape& shape : *static_cast<const std::vector<NamedShape>*>(value))
            map.set(shape.name, type_.base()->write(&shape.expression,
                                                    source ? source->find(shape.name) : nullptr));
        return map;
    }
    Node schema(SchemaBuilder& builder) const override {
        Node schema = schemaType("object");
        schema.set("additionalProperties", type_.base()->schema(builder));
        return schema;
    }
    std::string text() const override { return "map from names to shapes, see 'list shape'"; }
    bool absent(const void* value) const override {
        return static_cast<const std::vector<NamedShape>*>(value)->empty();
    }

 private:
    Type<SharedShapeExpression> type_ = shapeExpression();
};

}  // namespace

Type<SharedShapeExpression> shapeExpression() {
    return Type<SharedShapeExpression>(std::make_shared<ShapeType>());
}
Type<std::vector<NamedShape>> namedShapes() {
    return Type<std::vector<NamedShape>>(std::make_shared<NamedShapesType>());
}

}  // namespace sphinx::language
