// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/types.h"

#include "input/declaration/reader.h"
#include "input/declaration/schema.h"
#include "input/tree/suggest.h"

namespace sphinx::language {
namespace {

using namespace input;

/// How to use a vector of entries that contain a Component, and the struct of the common keys.
struct Entries {
    input::detail::Sequence sequence;
    Component* (*component)(void* entry);
    void* (*common)(void* entry);  ///< null when there are no common keys
};

class ComponentsType final : public TypeBase {
 public:
    ComponentsType(Kind kind, const Declaration* common, Entries entries)
        : kind_(kind), common_(common), entries_(entries) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isMap()) return reader.mismatch(node, "a map from names to {type: ..., ...}");
        entries_.sequence.clear(out);
        bool good = true;
        for (const Node::Entry& entry : node.entries) {
            void* item = entries_.sequence.append(out);
            good = readEntry(entry, reader, item) && good;
        }
        return good;
    }

    Node write(const void* value, const Node* source) const override {
        Node map = Node::map();
        for (std::size_t k = 0; k < entries_.sequence.size(value); ++k) {
            void* item = const_cast<void*>(entries_.sequence.element(value, k));
            const Component& component = *entries_.component(item);
            const Node* given = source ? source->find(component.name) : nullptr;
            Node one = Node::map().at(component.place);
            const Node* type = given ? given->find("type") : nullptr;
            one.set("type", Node::plain(component.declaration->name())
                                .at(type ? type->place : component.place));
            if (common_) writeParameters(*common_, entries_.common(item), given, one);
            writeParameters(*component.declaration, component.parameters.get(), given, one);
            map.set(component.name, std::move(one));
        }
        return map;
    }

    Node schema(SchemaBuilder& builder) const override {
        Node schema = schemaType("object");
        schema.set("additionalProperties", builder.define(kindName(kind_), [&] {
            return builder.component(kind_, common_);
        }));
        return schema;
    }
    std::string text() const override {
        return std::string("map from names to {type: NAME, ...}, see 'list ") + kindName(kind_) +
               "'";
    }
    bool absent(const void* value) const override { return entries_.sequence.size(value) == 0; }

 private:
    bool readEntry(const Node::Entry& entry, Reader& reader, void* item) const {
        Component& component = *entries_.component(item);
        component.name = entry.key;
        component.place = entry.place;
        bool good = checkNewName(entry.key, entry.place, reader.diagnostics);
        if (!entry.value.isMap())
            return reader.error(entry.value.isNull() ? entry.place : entry.value.place,
                                entry.value.isNull()
                                    ? "'" + entry.key + "' has no value"
                                    : entry.key + " is " + describeNode(entry.value) +
                                          " but must be a map {type: ..., ...}");
        const Label label(reader, entry.key);
        const Node* type = entry.value.find("type");
        if (!type || type->isNull())
            return reader.error(
                type ? type->place : entry.place,
                entry.key + " lacks 'type', one of: " + joined(reader.registry.names(kind_)));
        component.declaration =
            type->isScalar() ? reader.registry.find(kind_, type->text) : nullptr;
        if (!component.declaration)
            return reader.error(type->place,
                                "unknown type " + describeNode(*type) +
                                    didYouMean(type->text, reader.registry.names(kind_)));
        std::shared_ptr<void> parameters = component.declaration->makeParameters();
        std::vector<input::DeclaredStruct> parts{{component.declaration, parameters.get()}};
        if (common_) parts.push_back({common_, entries_.common(item)});
        good = readParameters(entry.value, entry.place, reader, parts, {"type"}) && good;
        component.parameters = std::move(parameters);
        for (const Node::Entry& given : entry.value.entries)
            component.parameter_places.emplace_back(given.key, given.value.place);
        return good;
    }

    Kind kind_;
    const Declaration* common_;
    Entries entries_;
};

}  // namespace

Type<std::vector<Component>> components(Kind kind) {
    const Entries entries{input::detail::sequenceOf<Component>(),
                          [](void* entry) { return static_cast<Component*>(entry); }, nullptr};
    return Type<std::vector<Component>>(std::make_shared<ComponentsType>(kind, nullptr, entries));
}

Type<std::vector<NamedOutput>> outputs(const Declaration& common) {
    const Entries entries{
        input::detail::sequenceOf<NamedOutput>(),
        [](void* entry) -> Component* { return static_cast<NamedOutput*>(entry); },
        [](void* entry) -> void* { return &static_cast<NamedOutput*>(entry)->block; }};
    return Type<std::vector<NamedOutput>>(
        std::make_shared<ComponentsType>(Kind::output, &common, entries));
}

}  // namespace sphinx::language
