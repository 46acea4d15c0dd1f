// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/reader.h"
#include "input/tree/suggest.h"
#include "input/types/type_support.h"
#include "input/types/type_templates.h"

#include <fmt/format.h>

namespace sphinx::input::detail {
namespace {

class ListType final : public TypeBase {
 public:
    ListType(TypePointer element, Sequence sequence)
        : element_(std::move(element)), sequence_(sequence) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isList()) return reader.mismatch(node, "a list [...]");
        sequence_.clear(out);
        bool good = true;
        for (std::size_t k = 0; k < node.items.size(); ++k) {
            const Label label(reader, fmt::format("item {} of {}", k + 1, reader.label));
            good = element_->read(node.items[k], reader, sequence_.append(out)) && good;
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        Node list = Node::list().at(placeOf(source));
        for (std::size_t k = 0; k < sequence_.size(value); ++k)
            list.add(element_->write(sequence_.element(value, k), itemOf(source, k)));
        return list;
    }
    Node schema(SchemaBuilder& builder) const override {
        Node schema = schemaType("array");
        schema.set("items", element_->schema(builder));
        return schema;
    }
    std::string text() const override { return "list of: " + element_->text(); }
    void names(const void* value, std::vector<Name>& names) const override {
        for (std::size_t k = 0; k < sequence_.size(value); ++k)
            element_->names(sequence_.element(value, k), names);
    }
    bool absent(const void* value) const override { return sequence_.size(value) == 0; }

 private:
    TypePointer element_;
    Sequence sequence_;
};

class MapType final : public TypeBase {
 public:
    MapType(TypePointer key, TypePointer value, Sequence sequence, Name* (*first)(void*),
            void* (*second)(void*))
        : key_(std::move(key)),
          value_(std::move(value)),
          sequence_(sequence),
          first_(first),
          second_(second) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isMap()) return reader.mismatch(node, "a map {...}");
        sequence_.clear(out);
        bool good = true;
        for (const Node::Entry& entry : node.entries) {
            void* pair = sequence_.append(out);
            Node key = Node::plain(entry.key).at(entry.place);
            good = key_->read(key, reader, first_(pair)) && good;
            const Label label(reader, entry.key);
            good = value_->read(entry.value, reader, second_(pair)) && good;
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        Node map = Node::map().at(placeOf(source));
        for (std::size_t k = 0; k < sequence_.size(value); ++k) {
            void* pair = const_cast<void*>(sequence_.element(value, k));
            const Name& name = *first_(pair);
            map.set(name.text,
                    value_->write(second_(pair), source ? source->find(name.text) : nullptr));
        }
        return map;
    }
    Node schema(SchemaBuilder& builder) const override {
        Node schema = schemaType("object");
        schema.set("additionalProperties", value_->schema(builder));
        return schema;
    }
    std::string text() const override {
        return "map of " + key_->text() + " to: " + value_->text();
    }
    void names(const void* value, std::vector<Name>& names) const override {
        for (std::size_t k = 0; k < sequence_.size(value); ++k) {
            void* pair = const_cast<void*>(sequence_.element(value, k));
            key_->names(first_(pair), names);
            value_->names(second_(pair), names);
        }
    }
    bool absent(const void* value) const override { return sequence_.size(value) == 0; }

 private:
    TypePointer key_;
    TypePointer value_;
    Sequence sequence_;
    Name* (*first_)(void*);
    void* (*second_)(void*);
};

class OptionalType final : public TypeBase {
 public:
    OptionalType(TypePointer type, OptionalAccess access)
        : type_(std::move(type)), access_(access) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        const bool good = type_->read(node, reader, access_.engage(out));
        if (!good) access_.reset(out);
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        const void* present = access_.get(value);
        return present ? type_->write(present, source) : Node{};
    }
    Node schema(SchemaBuilder& builder) const override { return type_->schema(builder); }
    std::string text() const override { return type_->text(); }
    void names(const void* value, std::vector<Name>& names) const override {
        if (const void* present = access_.get(value)) type_->names(present, names);
    }
    bool absent(const void* value) const override {
        const void* present = access_.get(value);
        return !present || type_->absent(present);
    }

 private:
    TypePointer type_;
    OptionalAccess access_;
};

class StructureType final : public TypeBase {
 public:
    explicit StructureType(const Declaration& declaration) : declaration_(declaration) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        return readParameters(node, node.place, reader, {{&declaration_, out}});
    }
    Node write(const void* value, const Node* source) const override {
        return writeStructure(declaration_, value, source);
    }
    Node schema(SchemaBuilder& builder) const override {
        return builder.define(declaration_.name(), [&] { return builder.object(declaration_); });
    }
    std::string text() const override { return "map, see '" + declaration_.name() + "'"; }
    std::string wanted() const override {
        std::vector<std::string> keys;
        for (const Parameter& p : declaration_.parameters()) keys.push_back(p.name);
        return mapOfKeys(keys);
    }
    void names(const void* value, std::vector<Name>& names) const override {
        for (const Parameter& p : declaration_.parameters()) p.type->names(p.in(value), names);
    }

 private:
    const Declaration& declaration_;
};

class WordOrType final : public TypeBase {
 public:
    WordOrType(std::string word, TypePointer type, OptionalAccess access)
        : word_(std::move(word)), type_(std::move(type)), access_(access) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        access_.reset(out);
        if (node.isScalar() && node.text == word_) return true;
        if (node.isScalar()) return reader.mismatch(node, "'" + word_ + "' or " + type_->wanted());
        return type_->read(node, reader, access_.engage(out));
    }
    Node write(const void* value, const Node* source) const override {
        const void* present = access_.get(value);
        return present ? type_->write(present, source) : Node::plain(word_).at(placeOf(source));
    }
    Node schema(SchemaBuilder& builder) const override {
        // {"if": string, "then": the word, "else": the rest} keeps messages to the point.
        Node schema = Node::map();
        schema.set("if", schemaType("string"));
        Node word = Node::map();
        word.set("const", Node::string(word_));
        schema.set("then", std::move(word));
        schema.set("else", type_->schema(builder));
        return schema;
    }
    std::string text() const override { return word_ + " | " + type_->text(); }

 private:
    std::string word_;
    TypePointer type_;
    OptionalAccess access_;
};

}  // namespace

TypePointer makeWordOr(std::string word, TypePointer type, OptionalAccess access) {
    return std::make_shared<WordOrType>(std::move(word), std::move(type), access);
}
TypePointer makeList(TypePointer element, Sequence sequence) {
    return std::make_shared<ListType>(std::move(element), sequence);
}
TypePointer makeMap(TypePointer key, TypePointer value, Sequence sequence, Name* (*first)(void*),
                    void* (*second)(void*)) {
    return std::make_shared<MapType>(std::move(key), std::move(value), sequence, first, second);
}
TypePointer makeOptional(TypePointer type, OptionalAccess access) {
    return std::make_shared<OptionalType>(std::move(type), access);
}
TypePointer makeStructure(const Declaration& declaration) {
    return std::make_shared<StructureType>(declaration);
}

}  // namespace sphinx::input::detail

namespace sphinx::input {

namespace {

/// A list of axes that the case has.
class AxesType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!list_->read(node, reader, out)) return false;
        const auto& axes = *static_cast<const std::vector<int>*>(out);
        for (std::size_t k = 0; k < axes.size(); ++k)
            if (reader.dimension > 0 && axes[k] >= reader.dimension)
                return reader.error(node.items[k], reader.label + " names z, but the case is 2D");
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return list_->write(value, source);
    }
    Node schema(SchemaBuilder& builder) const override { return list_->schema(builder); }
    std::string text() const override { return list_->text(); }
    bool absent(const void* value) const override { return list_->absent(value); }

 private:
    std::shared_ptr<const TypeBase> list_ =
        list(choice<int>({{"x", 0, ""}, {"y", 1, ""}, {"z", 2, ""}})).base();
};

}  // namespace

Type<std::vector<int>> axes() { return Type<std::vector<int>>(std::make_shared<AxesType>()); }

}  // namespace sphinx::input
