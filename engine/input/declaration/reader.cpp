// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/reader.h"

#include "input/tree/suggest.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace sphinx::input {
namespace {

std::vector<std::string> acceptedKeys(const std::vector<DeclaredStruct>& parts,
                                      const std::vector<std::string>& other_keys) {
    std::vector<std::string> keys = other_keys;
    for (const DeclaredStruct& part : parts)
        for (const Parameter& p : part.declaration->parameters()) keys.push_back(p.name);
    return keys;
}

/// Required keys that the node lacks, and that none of its unknown keys is nearly.
std::vector<std::string> missingKeys(const Node& node, const std::vector<DeclaredStruct>& parts,
                                     const std::vector<const Node::Entry*>& unknown) {
    std::vector<std::string> missing;
    for (const DeclaredStruct& part : parts)
        for (const Parameter& p : part.declaration->parameters()) {
            const bool misspelt =
                std::any_of(unknown.begin(), unknown.end(),
                            [&](const Node::Entry* entry) { return isNear(entry->key, p.name); });
            if (p.required && !misspelt && !node.find(p.name)) missing.push_back(p.name);
        }
    return missing;
}

bool readOne(const Node& node, const Place& place, Reader& reader, const DeclaredStruct& part,
             const std::vector<std::string>& missing) {
    bool good = true;
    for (const Parameter& p : part.declaration->parameters()) {
        const auto entry =
            std::find_if(node.entries.begin(), node.entries.end(),
                         [&](const Node::Entry& entry) { return entry.key == p.name; });
        if (entry == node.entries.end()) {
            if (std::find(missing.begin(), missing.end(), p.name) != missing.end())
                good = reader.error(place, reader.label + " lacks '" + p.name + "': " + p.doc);
            continue;
        }
        if (entry->value.isNull()) {
            good = reader.error(entry->place, "'" + p.name + "' has no value");
            continue;
        }
        const Label label(reader, p.name);
        good = p.type->read(entry->value, reader, p.member(part.parameters)) && good;
    }
    return good;
}

bool checkRules(const Node& node, const Place& place, Reader& reader, const DeclaredStruct& part) {
    for (const Declaration::Rule& rule : part.declaration->rules()) {
        const std::string violation = rule.violated(part.parameters, reader.units);
        if (violation.empty()) continue;
        const Node* given = node.find(rule.parameter);
        return reader.error(given ? given->place : place, violation);
    }
    return true;
}

}  // namespace

bool Reader::error(const Node& node, std::string message) {
    return error(node.place, node.isNull() ? label + " has no value" : std::move(message));
}

bool Reader::error(const Place& place, std::string message) {
    diagnostics.error(place, std::move(message));
    return false;
}

bool Reader::mismatch(const Node& node, const std::string& wanted) {
    return error(node, label + " is " + describeNode(node) + " but must be " + wanted);
}

bool Reader::hasMethod(std::string_view name) const {
    return std::find(methods.begin(), methods.end(), name) != methods.end();
}

std::optional<double> Reader::number(const Node& node, Dimension dimension) {
    const auto value = scope.number(node, dimension, label, units, diagnostics);
    // Squares and cubes of it are still numbers.
    constexpr double largest = 1e100;
    if (!value || std::abs(*value) <= largest) return value;
    error(node, fmt::format("{} is {:g} but must be between -{:g} and {:g}", label, *value, largest,
                            largest));
    return {};
}

std::string shownFile(const Node& node) {
    return (std::filesystem::path(node.place.source->folder) / node.text)
        .lexically_normal()
        .string();
}

bool readParameters(const Node& node, const Place& place, Reader& reader,
                    const std::vector<DeclaredStruct>& parts,
                    const std::vector<std::string>& other_keys) {
    if (parts.size() == 1 && parts[0].declaration->bare()) {
        const Parameter& value = parts[0].declaration->parameters().front();
        return value.type->read(node, reader, value.member(parts[0].parameters)) &&
               checkRules(node, node.place, reader, parts[0]);
    }
    const std::vector<std::string> accepted = acceptedKeys(parts, other_keys);
    if (!node.isMap()) return reader.mismatch(node, mapOfKeys(accepted));
    std::vector<const Node::Entry*> unknown;
    for (const Node::Entry& entry : node.entries)
        if (std::find(accepted.begin(), accepted.end(), entry.key) == accepted.end())
            unknown.push_back(&entry);
    std::vector<std::string> missing = missingKeys(node, parts, unknown);
    for (const Node::Entry* entry : unknown) {
        std::string message = "unknown key '" + entry->key + "'" + didYouMean(entry->key, accepted);
        // Probably it stands for one that is missing: one mistake, one message.
        if (!missing.empty() && !nearest(entry->key, accepted)) {
            message += "; missing: " + joined(missing);
            missing.clear();
        }
        reader.error(entry->place, std::move(message));
    }
    bool good = unknown.empty();
    for (const DeclaredStruct& part : parts)
        good = readOne(node, place, reader, part, missing) && good;
    for (const DeclaredStruct& part : parts)
        if (good) good = checkRules(node, place, reader, part);
    return good;
}

void writeParameters(const Declaration& declaration, const void* parameters, const Node* source,
                     Node& out) {
    for (const Parameter& p : declaration.parameters()) {
        const void* value = p.in(parameters);
        const Node* given = source ? source->find(p.name) : nullptr;
        const bool absent = p.type->absent(value);
        if (absent && !given) continue;
        Node written = p.type->write(value, given);
        if (absent && written.isMap() && written.entries.empty()) continue;
        out.set(p.name, std::move(written));
    }
}

Node writeStructure(const Declaration& declaration, const void* parameters, const Node* source) {
    if (declaration.bare()) {
        const Parameter& value = declaration.parameters().front();
        return value.type->write(value.in(parameters), source);
    }
    Node map = Node::map().at(source ? source->place : Place{});
    writeParameters(declaration, parameters, source, map);
    return map;
}

}  // namespace sphinx::input
