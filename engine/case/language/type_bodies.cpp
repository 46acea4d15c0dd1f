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

class SeenType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& seen = *static_cast<model::Seen*>(out);
        const Node* body = &node;
        if (node.isMap()) {
            const std::string key = node.entries.size() == 1 ? node.entries[0].key : "";
            if (key != "bonded" && key != "contact")
                return reader.error(node, reader.label +
                                              " must be self, the name of a body, {bonded: NAME}, "
                                              "{contact: NAME} or {contact: self}");
            body = &node.entries[0].value;
            seen.as = key == "bonded" ? model::SeenAs::bonded : model::SeenAs::contact;
        }
        if (body->isScalar() && body->text == "self" && seen.as != model::SeenAs::bonded) {
            seen.body = {"self", body->place};
            return true;
        }
        return bodyReference({"fluid", "solid"}).base()->read(*body, reader, &seen.body);
    }
    Node write(const void* value, const Node* source) const override {
        const auto& seen = *static_cast<const model::Seen*>(value);
        const Place place = source ? source->place : seen.body.place;
        Node name = Node::plain(seen.body.text).at(place);
        if (seen.as == model::SeenAs::flow) return name;
        Node map = Node::map().at(place);
        map.set(seen.as == model::SeenAs::bonded ? "bonded" : "contact", std::move(name));
        return map;
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        schema.set("type", Node::list({Node::string("string"), Node::string("object")}));
        Node properties = Node::map();
        properties.set("bonded", schemaType("string"));
        properties.set("contact", schemaType("string"));
        schema.set("properties", std::move(properties));
        schema.set("minProperties", Node::plain("1"));
        schema.set("maxProperties", Node::plain("1"));
        schema.set("additionalProperties", Node::plain("false"));
        return schema;
    }
    std::string text() const override {
        return "self | name of a body | {bonded: name of a body} | {contact: name of a body, or "
               "self}";
    }
};

class FollowedType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& followed = *static_cast<model::Followed*>(out);
        if (node.isMap() && node.entries.size() == 1 && node.entries[0].key == "body") {
            followed.what = model::Follows::solid;
            return partReference({"rigid"}).base()->read(node.entries[0].value, reader,
                                                         &followed.solid);
        }
        followed.what = node.text == "material" ? model::Follows::material : model::Follows::space;
        return (node.isScalar() && (node.text == "space" || node.text == "material")) ||
               reader.mismatch(node, "space, material or {body: NAME}");
    }
    Node write(const void* value, const Node* source) const override {
        const auto& followed = *static_cast<const model::Followed*>(value);
        const Place place = source ? source->place : Place{};
        if (followed.what != model::Follows::solid)
            return Node::plain(followed.what == model::Follows::material ? "material" : "space")
                .at(place);
        Node map = Node::map().at(place);
        map.set("body", Node::plain(followed.solid.text).at(followed.solid.place));
        return map;
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        schema.set("type", Node::list({Node::string("string"), Node::string("object")}));
        Node properties = Node::map();
        properties.set("body", schemaType("string"));
        schema.set("properties", std::move(properties));
        schema.set("required", Node::list({Node::string("body")}));
        schema.set("additionalProperties", Node::plain("false"));
        return schema;
    }
    std::string text() const override {
        return "space (stays where it is) | material (moves with the particles nearest at its "
               "first row: in a fluid it drifts with the flow) | {body: NAME} (moves and turns "
               "with a rigid body, or a part of one)";
    }
};

}  // namespace

Type<model::Followed> followed() { return Type<model::Followed>(std::make_shared<FollowedType>()); }
Type<std::vector<NamedBody>> namedBodies(const Declaration& body) {
    return Type<std::vector<NamedBody>>(std::make_shared<NamedBodiesType>(body));
}
Type<model::Seen> seen() { return Type<model::Seen>(std::make_shared<SeenType>()); }

}  // namespace sphinx::language
