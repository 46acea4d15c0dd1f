// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/reader.h"
#include "input/declaration/schema.h"
#include "input/tree/suggest.h"

#include <algorithm>

namespace sphinx::input {
namespace {

const char* targetName(Target target) {
    switch (target) {
        case Target::body: return "body";
        case Target::part: return "body or part";
        case Target::material: return "material";
        case Target::shape: return "shape";
        case Target::method: return "method";
        case Target::action: return "method or METHOD.ACTION";
        case Target::layer: return "layer";
        case Target::field: return "field";
        case Target::rigid_body: return "body of multibody";
        case Target::rigid_body_or_ground: return "body of multibody, or ground";
        case Target::joint: return "joint";
        case Target::multibody_force: return "force of multibody";
    }
    return "";
}

class ReferenceType final : public TypeBase {
 public:
    ReferenceType(Target target, std::vector<std::string> traits)
        : target_(target), traits_(std::move(traits)) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isScalar())
            return reader.mismatch(node, std::string("the name of a ") + targetName(target_));
        auto& name = *static_cast<Name*>(out);
        name.text = node.text;
        name.place = node.place;
        reader.references.push_back({target_, traits_, name, reader.label});
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        return Node::plain(static_cast<const Name*>(value)->text)
            .at(source ? source->place : Place{});
    }
    Node schema(SchemaBuilder&) const override { return schemaType("string"); }
    std::string text() const override {
        const std::string kind = traits_.empty() ? "" : alternatives(traits_) + " ";
        return "name of " + withArticle(kind + targetName(target_));
    }
    void names(const void* value, std::vector<Name>& names) const override {
        const auto& name = *static_cast<const Name*>(value);
        if (!name.empty()) names.push_back(name);
    }
    bool absent(const void* value) const override {
        return static_cast<const Name*>(value)->empty();
    }

 private:
    Target target_;
    std::vector<std::string> traits_;
};

class NewNameType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        if (!node.isScalar()) return reader.mismatch(node, "a name");
        *static_cast<Name*>(out) = {node.text, node.place};
        return checkNewName(node.text, node.place, reader.diagnostics);
    }
    Node write(const void* value, const Node* source) const override {
        return Node::plain(static_cast<const Name*>(value)->text)
            .at(source ? source->place : Place{});
    }
    Node schema(SchemaBuilder&) const override { return schemaType("string"); }
    std::string text() const override { return "name"; }
    bool absent(const void* value) const override {
        return static_cast<const Name*>(value)->empty();
    }
};

Type<Name> reference(Target target, std::vector<std::string> traits = {}) {
    return Type<Name>(std::make_shared<ReferenceType>(target, std::move(traits)));
}

}  // namespace

Type<Name> bodyReference(std::vector<std::string> traits) {
    return reference(Target::body, std::move(traits));
}
Type<Name> partReference(std::vector<std::string> traits) {
    return reference(Target::part, std::move(traits));
}
Type<Name> materialReference(std::vector<std::string> traits) {
    return reference(Target::material, std::move(traits));
}
Type<Name> shapeReference() { return reference(Target::shape); }
Type<Name> actionReference() { return reference(Target::action); }
Type<Name> layerReference() { return reference(Target::layer); }
Type<Name> fieldReference() { return reference(Target::field); }
Type<Name> rigidBodyReference(bool or_ground) {
    return reference(or_ground ? Target::rigid_body_or_ground : Target::rigid_body);
}
Type<Name> jointReference() { return reference(Target::joint); }
Type<Name> multibodyForceReference() { return reference(Target::multibody_force); }
Type<Name> newName() { return Type<Name>(std::make_shared<NewNameType>()); }

bool checkNewName(const std::string& name, const Place& place, Diagnostics& diagnostics) {
    const auto report = [&](std::string message) {
        diagnostics.error(place, std::move(message));
        return false;
    };
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    const bool word = !name.empty() && letter(name[0]) &&
                      std::all_of(name.begin(), name.end(),
                                  [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
    if (!word)
        return report(
            "'" + name.substr(0, 60) +
            "' cannot be a name: names are letters, digits and _, and start with a letter");
    if (name.size() > 60) return report("the name '" + name.substr(0, 60) + "...' is too long");
    std::string lower = name;
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    for (const char* word : {"on", "off", "yes", "no", "y", "n", "true", "false", "null"})
        if (lower == word)
            return report("'" + name +
                          "' cannot be a name: YAML programs read it as a truth value");
    return true;
}

}  // namespace sphinx::input
