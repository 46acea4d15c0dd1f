// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"

#include <functional>

namespace sphinx::input {

/// Builds the JSON Schema (draft-07) of the language from the declarations.
class SchemaBuilder {
 public:
    explicit SchemaBuilder(const Registry& registry) : registry(registry) {}

    const Registry& registry;

    /// True: for files that include others and add to their maps, so that keys may be missing.
    bool partial = false;

    /// A reference to a definition, which is made once (and once more where keys may be missing).
    Node define(const std::string& name, const std::function<Node()>& make);
    /// Schema of a map with the keys of the declaration, or of its bare value.
    Node object(const Declaration& declaration);
    /// An entry of a block whose `type` chooses from the registry; `common` has the other keys.
    Node component(Kind kind, const Declaration* common);

    /// All definitions made so far, in the order of their first use.
    const Node& definitions() const { return definitions_; }

 private:
    void addProperties(const Declaration& declaration, Node& properties, Node& required);

    Node definitions_ = Node::map();
};

/// {"type": NAME} and other one-key beginnings of a schema.
Node schemaType(const std::string& type);
/// The whole document for a case, whose top level is that block.
std::string jsonSchema(const Registry& registry, const Declaration& top);

}  // namespace sphinx::input
