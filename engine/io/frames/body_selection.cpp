// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "io/frames/body_selection.h"

#include "input/declaration/declaration.h"
#include "input/declaration/reader.h"
#include "input/declaration/schema.h"
#include "input/types/type_templates.h"

namespace sphinx::io {
namespace {

using namespace input;

class BodySelectionType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& selection = *static_cast<BodySelection*>(out);
        selection.clear();
        if (node.isList()) {
            std::vector<Name> bodies;
            if (!bodies_.base()->read(node, reader, &bodies)) return false;
            for (Name& body : bodies) selection.push_back({std::move(body), std::nullopt});
            return checkBodies(node, reader, selection);
        }
        if (!node.isMap())
            return reader.error(node, reader.label + " is " + describeNode(node) +
                                          " but must be a list of bodies or a map from bodies to "
                                          "lists of fields");
        FieldsOfBodies fields;
        if (!fields_.base()->read(node, reader, &fields)) return false;
        for (auto& [body, names] : fields) selection.push_back({body, std::move(names)});
        return checkBodies(node, reader, selection);
    }
    Node write(const void* value, const Node* source) const override {
        const auto& selection = *static_cast<const BodySelection*>(value);
        if (!selection.empty() && !selection.front().fields) {
            std::vector<Name> bodies;
            for (const SelectedBody& one : selection) bodies.push_back(one.body);
            return bodies_.base()->write(&bodies, source);
        }
        FieldsOfBodies fields;
        for (const SelectedBody& one : selection) fields.emplace_back(one.body, *one.fields);
        return fields_.base()->write(&fields, source);
    }
    Node schema(SchemaBuilder& builder) const override {
        Node schema = Node::map();
        schema.set("if", schemaType("array"));
        schema.set("then", bodies_.base()->schema(builder));
        schema.set("else", fields_.base()->schema(builder));
        return schema;
    }
    std::string text() const override {
        return "list of bodies, or map from bodies to lists of fields";
    }
    void names(const void* value, std::vector<Name>& names) const override {
        for (const SelectedBody& one : *static_cast<const BodySelection*>(value)) {
            names.push_back(one.body);
            if (one.fields) names.insert(names.end(), one.fields->begin(), one.fields->end());
        }
    }
    bool absent(const void* value) const override {
        return static_cast<const BodySelection*>(value)->empty();
    }

 private:
    using FieldsOfBodies = std::vector<std::pair<Name, std::vector<Name>>>;

    /// No selection stands for all bodies, so an empty one that was written would surprise.
    static bool checkBodies(const Node& node, Reader& reader, const BodySelection& selection) {
        for (auto one = selection.begin(); one != selection.end(); ++one)
            for (auto other = selection.begin(); other != one; ++other)
                if (other->body.text == one->body.text)
                    return reader.error(one->body.place, "'" + one->body.text + "' is named twice");
        if (!selection.empty()) return true;
        return reader.error(node,
                            reader.label + " is empty; without the key all bodies are written");
    }

    Type<std::vector<Name>> bodies_ = list(bodyReference({"fluid", "solid"}));
    Type<FieldsOfBodies> fields_ = mapOf(bodyReference({"fluid", "solid"}), list(fieldReference()));
};

template <int Dim>
BodyFrames<Dim> defaultFrames(const bodies::Body<Dim>& body) {
    BodyFrames<Dim> frames{&body, {}};
    const auto add = [&](const particles::FieldInfo& field) {
        if (body.particles.find(field.name)) frames.fields.emplace_back(field.name);
    };
    add(fields::velocity);
    if (body.isFluid()) {
        add(fields::density);
        add(fields::pressure);
    } else {
        add(fields::normal);
    }
    return frames;
}

}  // namespace

Type<BodySelection> bodySelection() {
    return Type<BodySelection>(std::make_shared<BodySelectionType>());
}

template <int Dim>
std::vector<BodyFrames<Dim>> selectFrames(const BodySelection& selection,
                                          const bodies::World<Dim>& world) {
    std::vector<BodyFrames<Dim>> frames;
    if (selection.empty()) {
        for (const auto& body : world.bodies)
            if (!body->isObserver()) frames.push_back(defaultFrames(*body));
        return frames;
    }
    for (const SelectedBody& one : selection) {
        const bodies::Body<Dim>& body = *world.find(one.body.text);
        if (!one.fields) {
            frames.push_back(defaultFrames(body));
            continue;
        }
        BodyFrames<Dim>& named = frames.emplace_back(BodyFrames<Dim>{&body, {}});
        for (const Name& field : *one.fields) {
            fieldOf(body, field);
            named.fields.push_back(field.text);
        }
    }
    return frames;
}

template std::vector<BodyFrames<2>> selectFrames(const BodySelection&, const bodies::World<2>&);
template std::vector<BodyFrames<3>> selectFrames(const BodySelection&, const bodies::World<3>&);

}  // namespace sphinx::io
