// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/read.h"

#include "case/language/changes.h"
#include "case/language/phases.h"
#include "case/language/rules.h"
#include "core/read_file.h"
#include "input/expressions/decimal.h"
#include "input/tree/load.h"
#include "io/file/compress.h"

#include <fmt/format.h>
#include <filesystem>

namespace sphinx::language {
namespace {

using namespace input;

const std::vector<std::string> named_blocks{"variables", "tables",   "geometry", "materials",
                                            "bodies",    "topology", "dynamics", "outputs"};

/// Reports for a block what its own declaration cannot know: its place.
void placeDomain(const Node& root, CaseBlock& block) {
    const Node* domain = root.find("domain");
    if (!domain) return;
    const Node* periodic = domain->find("periodic");
    block.domain.place = periodic ? periodic->place : domain->place;
}

std::string contentText(const std::string& path) {
    const std::string content = readFile(path);
    return fmt::format("{} ({} bytes, fingerprint {:016x})",
                       std::filesystem::path(path).filename().string(), content.size(),
                       io::fingerprint(content));
}

/// What a newer language has may look wrong in many places; the cause is one.
void requireKnownVersion(const Node& root, Diagnostics& diagnostics) {
    const Node* node = root.find("sphinx");
    const auto version = node ? parseDecimal<int>(node->text) : std::nullopt;
    if (!version || *version <= language_version) return;
    diagnostics.error(node->place,
                      fmt::format("the case is written in version {} of the language, and this "
                                  "program knows versions 1 to {}; a newer program is needed",
                                  *version, language_version));
    diagnostics.throwIfErrors();
}

model::Case interpret(const Node& root, const Registry& registry, Diagnostics& diagnostics) {
    diagnostics.throwIfErrors();
    requireKnownVersion(root, diagnostics);
    Reader reader(diagnostics, registry);
    reader.label = "the case";
    if (const Node* dynamics = root.find("dynamics"))
        for (const Node::Entry& entry : dynamics->entries) reader.methods.push_back(entry.key);
    const Declaration& declaration = *registry.find(Kind::block, "case");
    CaseBlock block;
    announceTables(root, reader, block.tables);
    readParameters(root, root.place, reader, {{&declaration, &block}});
    checkNames(block, root, reader);
    diagnostics.throwIfErrors();

    placeDomain(root, block);
    checkSense(block, reader.units, diagnostics);
    checkTableTimes(reader, block.loop);
    diagnostics.throwIfErrors();
    model::Case model = makeModel(block, reader.units, diagnostics);
    diagnostics.throwIfErrors();

    model.registry = &registry;
    checkRules(model, diagnostics);
    diagnostics.throwIfErrors();
    warnUnused(block, reader);
    warnChanges(model, block.version, languageChanges(), diagnostics);
    model.version = block.version;
    model.state_version = stateVersion(model, languageChanges());
    model.warnings = diagnostics.text();
    for (const std::string& path : reader.files) model.files[path] = contentText(path);
    block.variables = reader.scope.usedByFields();
    std::erase_if(block.tables, [&](const NamedTable& table) {
        return !reader.scope.isUsedByFields(table.name);
    });
    model.resolved = writeStructure(declaration, &block, &root);
    // What is resolved means what this version says, whichever the case was written in.
    if (block.version != language_version)
        model.resolved.set("sphinx", Node::integer(language_version));
    return model;
}

}  // namespace

model::Case readCase(const std::string& path, const std::vector<std::string>& overrides,
                     const Registry& registry) {
    Diagnostics diagnostics;
    const LoadedCase loaded = loadCase(path, overrides, named_blocks, diagnostics);
    model::Case model = interpret(loaded.root, registry, diagnostics);
    model.path = path;
    model.sources = loaded.files;
    return model;
}

model::Case readCaseText(const std::string& name, const std::string& text,
                         const Registry& registry) {
    Diagnostics diagnostics;
    const LoadedCase loaded = loadText(name, text, {}, named_blocks, diagnostics);
    model::Case model = interpret(loaded.root, registry, diagnostics);
    model.path = name;
    return model;
}

}  // namespace sphinx::language
