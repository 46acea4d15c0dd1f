// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/types.h"

#include "input/declaration/reader.h"
#include "input/declaration/schema.h"
#include "input/tree/suggest.h"

namespace sphinx::language {
namespace {

using namespace input;

class KernelNameType final : public TypeBase {
 public:
    explicit KernelNameType(const Registry& registry) : registry_(registry) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        const Declaration* kernel =
            node.isScalar() ? registry_.find(Kind::kernel, node.text) : nullptr;
        if (!kernel)
            return reader.error(node, "there is no kernel " + describeNode(node) +
                                          didYouMean(node.text, registry_.names(Kind::kernel)));
        *static_cast<kernels::KernelType*>(out) = kernel->builder<kernels::KernelType>();
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        const char* name = kernels::kernelName(*static_cast<const kernels::KernelType*>(value));
        return Node::plain(name).at(source ? source->place : Place{});
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        Node& names = schema.set("enum", Node::list());
        for (const std::string& name : registry_.names(Kind::kernel)) names.add(Node::string(name));
        return schema;
    }
    std::string text() const override {
        std::string text;
        for (const std::string& name : registry_.names(Kind::kernel))
            text += (text.empty() ? "" : " | ") + name;
        return text;
    }

 private:
    const Registry& registry_;
};

class VariablesType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isMap()) return reader.mismatch(node, "a map from names to numbers");
        const std::size_t before = reader.diagnostics.errors();
        for (const Node::Entry& entry : node.entries)
            checkNewName(entry.key, entry.place, reader.diagnostics);
        reader.scope.define(node, reader.units, reader.diagnostics, reader.dimension);
        *static_cast<Node*>(out) = node;
        return reader.diagnostics.errors() == before;
    }
    Node write(const void* value, const Node*) const override {
        return *static_cast<const Node*>(value);
    }
    Node schema(SchemaBuilder&) const override {
        Node number = Node::map();
        number.set("type", Node::list({Node::string("number"), Node::string("string")}));
        Node schema = schemaType("object");
        schema.set("additionalProperties", std::move(number));
        return schema;
    }
    std::string text() const override {
        return "map from names to numbers, quantities, expressions";
    }
    bool absent(const void* value) const override {
        return static_cast<const Node*>(value)->entries.empty();
    }
};

class EffectType final : public TypeBase {
 public:
    using Effect = std::function<void(Reader&, const void*)>;
    EffectType(std::shared_ptr<const TypeBase> type, Effect effect)
        : type_(std::move(type)), effect_(std::move(effect)) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!type_->read(node, reader, out)) return false;
        effect_(reader, out);
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return type_->write(value, source);
    }
    Node schema(SchemaBuilder& builder) const override { return type_->schema(builder); }
    std::string text() const override { return type_->text(); }

 private:
    std::shared_ptr<const TypeBase> type_;
    Effect effect_;
};

}  // namespace

Type<kernels::KernelType> kernel(const Registry& registry) {
    return Type<kernels::KernelType>(std::make_shared<KernelNameType>(registry));
}
Type<Node> variables() { return Type<Node>(std::make_shared<VariablesType>()); }

std::shared_ptr<const TypeBase> withEffect(std::shared_ptr<const TypeBase> type,
                                           std::function<void(Reader&, const void*)> effect) {
    return std::make_shared<EffectType>(std::move(type), std::move(effect));
}

}  // namespace sphinx::language
