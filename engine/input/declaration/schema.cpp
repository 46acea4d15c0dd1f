// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/schema.h"

#include "input/tree/json.h"

namespace sphinx::input {
namespace {

/// A schema with a description; next to "$ref" draft-07 ignores every other keyword.
Node described(Node schema, const std::string& doc, const Node& default_value) {
    if (schema.find("$ref")) {
        Node wrapped = Node::map();
        wrapped.set("allOf", Node::list({std::move(schema)}));
        schema = std::move(wrapped);
    }
    if (!doc.empty()) schema.set("description", Node::string(doc));
    if (!default_value.isNull()) schema.set("default", default_value);
    return schema;
}

}  // namespace

Node schemaType(const std::string& type) {
    Node schema = Node::map();
    schema.set("type", Node::string(type));
    return schema;
}

Node SchemaBuilder::define(const std::string& name, const std::function<Node()>& make) {
    const std::string key = (partial ? "partial_" : "") + name;
    if (!definitions_.find(key)) {
        definitions_.set(key, Node::map());  // a definition may refer to itself
        Node made = make();
        definitions_.set(key, std::move(made));
    }
    Node reference = Node::map();
    reference.set("$ref", Node::string("#/definitions/" + key));
    return reference;
}

void SchemaBuilder::addProperties(const Declaration& declaration, Node& properties,
                                  Node& required) {
    const std::shared_ptr<void> defaults = declaration.makeParameters();
    for (const Parameter& p : declaration.parameters()) {
        const void* value = p.in(defaults.get());
        const bool has_default = !p.required && !p.type->absent(value);
        properties.set(p.name, described(p.type->schema(*this), p.doc,
                                         has_default ? p.type->write(value, nullptr) : Node{}));
        if (p.required) required.add(Node::string(p.name));
    }
}

Node SchemaBuilder::object(const Declaration& declaration) {
    if (declaration.bare()) return declaration.parameters().front().type->schema(*this);
    Node schema = schemaType("object");
    if (!declaration.summary().empty())
        schema.set("description", Node::string(declaration.summary()));
    Node properties = Node::map();
    Node required = Node::list();
    addProperties(declaration, properties, required);
    schema.set("properties", std::move(properties));
    if (!required.items.empty() && !partial) schema.set("required", std::move(required));
    schema.set("additionalProperties", Node::plain("false"));
    return schema;
}

Node SchemaBuilder::component(Kind kind, const Declaration* common) {
    // The choice by if/then: an editor then complains about the one variant that `type` names.
    Node schema = schemaType("object");
    Node names = Node::list();
    Node variants = Node::list();
    for (const std::string& name : registry.names(kind)) {
        names.add(Node::string(name));
        const Declaration& declaration = *registry.find(kind, name);
        Node then = Node::map();
        if (!declaration.summary().empty())
            then.set("description", Node::string(declaration.summary()));
        Node properties = Node::map();
        Node required = Node::list({Node::string("type")});
        properties.set("type", Node::map());
        if (common) addProperties(*common, properties, required);
        addProperties(declaration, properties, required);
        then.set("properties", std::move(properties));
        if (!partial) then.set("required", std::move(required));
        then.set("additionalProperties", Node::plain("false"));

        Node constant = Node::map();
        constant.set("const", Node::string(name));
        Node type = Node::map();
        type.set("type", std::move(constant));
        Node condition = Node::map();
        condition.set("properties", std::move(type));
        condition.set("required", Node::list({Node::string("type")}));
        Node variant = Node::map();
        variant.set("if", std::move(condition));
        variant.set("then", std::move(then));
        variants.add(std::move(variant));
    }
    Node choice = Node::map();
    choice.set("enum", std::move(names));
    Node properties = Node::map();
    properties.set("type", std::move(choice));
    schema.set("properties", std::move(properties));
    if (!partial) schema.set("required", Node::list({Node::string("type")}));
    if (!variants.items.empty()) schema.set("allOf", std::move(variants));
    return schema;
}

std::string jsonSchema(const Registry& registry, const Declaration& top) {
    SchemaBuilder builder(registry);
    Node schema = Node::map();
    schema.set("$schema", Node::string("http://json-schema.org/draft-07/schema#"));
    schema.set("title", Node::string("sphinx case"));
    Node includes = Node::map();
    includes.set("required", Node::list({Node::string("include")}));
    const auto whole = [&] { return builder.define("case", [&] { return builder.object(top); }); };
    schema.set("if", std::move(includes));
    builder.partial = true;
    schema.set("then", whole());
    builder.partial = false;
    schema.set("else", whole());
    schema.set("definitions", builder.definitions());
    return writeJson(schema);
}

}  // namespace sphinx::input
