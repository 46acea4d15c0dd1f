// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/read.h"

#include "case/language/phases.h"
#include "core/read_file.h"
#include "input/tree/load.h"
#include "io/file/compress.h"

#include <fmt/format.h>
#include <filesystem>

namespace sphinx::model {
namespace {

using namespace input;

const std::vector<std::string> named_blocks{"variables", "geometry", "materials", "bodies",
                                            "topology",  "dynamics", "outputs"};

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

Case interpret(const Node& root, const Registry& registry, Diagnostics& diagnostics) {
    diagnostics.throwIfErrors();
    Reader reader(diagnostics, registry);
    reader.label = "the case";
    if (const Node* dynamics = root.find("dynamics"))
        for (const Node::Entry& entry : dynamics->entries) reader.methods.push_back(entry.key);
    const Declaration& declaration = *registry.find(Kind::block, "case");
    CaseBlock block;
    readParameters(root, root.place, reader, {{&declaration, &block}});
    checkNames(block, root, reader);
    diagnostics.throwIfErrors();

    placeDomain(root, block);
    checkSense(block, reader.units, diagnostics);
    diagnostics.throwIfErrors();
    Case model = makeModel(block, reader.units, diagnostics);
    diagnostics.throwIfErrors();

    warnUnused(block, reader);
    model.warnings = diagnostics.text();
    for (const std::string& path : reader.files) model.files[path] = contentText(path);
    block.variables = reader.scope.usedByFields();
    model.resolved = writeStructure(declaration, &block, &root);
    return model;
}

}  // namespace

Case readCase(const std::string& path, const std::vector<std::string>& overrides,
              const Registry& registry) {
    Diagnostics diagnostics;
    const LoadedCase loaded = loadCase(path, overrides, named_blocks, diagnostics);
    Case model = interpret(loaded.root, registry, diagnostics);
    model.path = path;
    model.sources = loaded.files;
    return model;
}

Case readCaseText(const std::string& name, const std::string& text, const Registry& registry) {
    Diagnostics diagnostics;
    const LoadedCase loaded = loadText(name, text, {}, named_blocks, diagnostics);
    Case model = interpret(loaded.root, registry, diagnostics);
    model.path = name;
    return model;
}

}  // namespace sphinx::model
