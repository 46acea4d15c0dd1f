// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/types.h"

#include "input/declaration/reader.h"
#include "input/declaration/schema.h"

namespace sphinx::language {
namespace {

using namespace input;

class NamedBodiesType final : public TypeBase {
 public:
    explicit NamedBodiesType(const Declaration& body) : body_(body) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isMap()) return reader.mismatch(node, "a map from names to bodies");
        auto& bodies = *static_cast<std::vector<NamedBody>*>(out);
        bool good = true;
        for (const Node::Entry& entry : node.entries) {
            NamedBody& body = bodies.emplace_back();
            body.name = entry.key;
            body.place = entry.place;
            if (entry.key == "self")
                reader.error(entry.place, "a body cannot be called 'self': topology uses the word");
            const bool good_name = checkNewName(entry.key, entry.place, reader.diagnostics);
            const Label label(reader, entry.key);
            if (entry.value.isNull())
                reader.error(entry.place, "'" + entry.key + "' has no value");
            else
                body.good =
                    readParameters(entry.value, entry.place, reader, {{&body_, &body.block}}) &&
                    good_name;
            for (const Node::Entry& given : entry.value.entries)
                body.given.emplace_back(given.key, given.place);
            good = good && body.good;
        }
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        Node map = Node::map();
        for (const NamedBody& body : *static_cast<const std::vector<NamedBody>*>(value)) {
            Node one = Node::map().at(body.place);
            writeParameters(body_, &body.block, source ? source->find(body.name) : nullptr, one);
            map.set(body.name, std::move(one));
        }
        return map;
    }
    Node schema(SchemaBuilder& builder) const override {
        Node schema = schemaType("object");
        schema.set("additionalProperties",
                   builder.define("body", [&] { return builder.object(body_); }));
        return schema;
    }
    std::string text() const override { return "map from names to bodies, see 'bodies'"; }

 private:
    const Declaration& body_;
};

class ContactType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& contact = *static_cast<ContactBlock*>(out);
        const Node* body = &node;
        if (node.isMap()) {
            if (node.entries.size() != 1 || node.entries[0].key != "bonded")
                return reader.error(
                    node, reader.label + " must be self, the name of a body or {bonded: NAME}");
            body = &node.entries[0].value;
            contact.bonded = true;
        }
        if (body->isScalar() && body->text == "self" && !contact.bonded) {
            contact.body = {"self", body->place};
            return true;
        }
        return bodyReference({"fluid", "solid"}).base()->read(*body, reader, &contact.body);
    }
    Node write(const void* value, const Node* source) const override {
        const auto& contact = *static_cast<const ContactBlock*>(value);
        const Place place = source ? source->place : contact.body.place;
        Node name = Node::plain(contact.body.text).at(place);
        if (!contact.bonded) return name;
        Node map = Node::map().at(place);
        map.set("bonded", std::move(name));
        return map;
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        schema.set("type", Node::list({Node::string("string"), Node::string("object")}));
        Node properties = Node::map();
        properties.set("bonded", schemaType("string"));
        schema.set("properties", std::move(properties));
        schema.set("required", Node::list({Node::string("bonded")}));
        schema.set("additionalProperties", Node::plain("false"));
        return schema;
    }
    std::string text() const override { return "self | name of a body | {bonded: name of a body}"; }
};

}  // namespace

Type<std::vector<NamedBody>> namedBodies(const Declaration& body) {
    return Type<std::vector<NamedBody>>(std::make_shared<NamedBodiesType>(body));
}
Type<ContactBlock> contact() { return Type<ContactBlock>(std::make_shared<ContactType>()); }

}  // namespace sphinx::language
