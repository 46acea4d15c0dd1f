// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/registry.h"
#include "input/expressions/scope.h"
#include "input/expressions/units.h"
#include "input/tree/diagnostics.h"

namespace sphinx::input {

/// What a reference may point at.
enum class Target {
    body,
    part,
    material,
    shape,
    method,
    action,
    layer,
    field,
    rigid_body,
    rigid_body_or_ground,
    joint,
    multibody_force
};

/// A name that was read, to be checked once everything that could be named is known.
struct Reference {
    Target target;
    std::vector<std::string> traits;  ///< wanted; empty: any
    Name name;
    std::string label;  ///< key it was given for
};

/// The state of reading a case: what types need besides the node.
class Reader {
 public:
    Reader(Diagnostics& diagnostics, const Registry& registry)
        : diagnostics(diagnostics), registry(registry) {}

    Diagnostics& diagnostics;
    const Registry& registry;
    int dimension = 0;  ///< 0 while unknown
    UnitSystem units;
    Scope scope;
    std::vector<Reference> references;
    std::vector<std::string> files;    ///< absolute, those that values name
    std::string label;                 ///< key of the value being read, for messages
    std::vector<std::string> methods;  ///< names in `dynamics`, known before the block is read
    bool hasMethod(std::string_view name) const;

    /// Reports and returns false.
    bool error(const Node& node, std::string message);
    bool error(const Place& place, std::string message);
    /// "LABEL is WHAT IT IS but must be `wanted`".
    bool mismatch(const Node& node, const std::string& wanted);

    /// Number, quantity or expression in case units; reports and returns nothing when it is none.
    std::optional<double> number(const Node& node, Dimension dimension);
};

/// A struct to be filled and what declares it.
struct DeclaredStruct {
    const Declaration* declaration;
    void* parameters;
};

/// Reads a map whose keys are those of all parts, besides `other_keys` that the caller reads.
/// `place` is where a missing key is reported.
bool readParameters(const Node& node, const Place& place, Reader& reader,
                    const std::vector<DeclaredStruct>& parts,
                    const std::vector<std::string>& other_keys = {});
/// The resolved map of one part appended to `out`.
void writeParameters(const Declaration& declaration, const void* parameters, const Node* source,
                     Node& out);

/// The resolved map, or the bare value, as a node of its own.
Node writeStructure(const Declaration& declaration, const void* parameters, const Node* source);

/// Reports unless the text can name something of a case: a word that no YAML program takes for
/// something else.
bool checkNewName(const std::string& name, const Place& place, Diagnostics& diagnostics);

/// The file that a scalar names, relative to where the program runs.
std::string shownFile(const Node& node);

/// Sets reader.label for its own life.
class Label {
 public:
    Label(Reader& reader, std::string label) : reader_(reader), saved_(std::move(reader.label)) {
        reader.label = std::move(label);
    }
    ~Label() { reader_.label = std::move(saved_); }
    Label(const Label&) = delete;
    Label& operator=(const Label&) = delete;

 private:
    Reader& reader_;
    std::string saved_;
};

}  // namespace sphinx::input
