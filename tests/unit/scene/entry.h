// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "input/declaration/component.h"
#include "input/declaration/reader.h"
#include "input/tree/yaml.h"

#include <string>

namespace sphinx::test {

/// An entry of `dynamics` or `outputs` as a case writes it: "{type: ..., ...}".
inline input::Component readEntry(const std::string& yaml, input::Kind kind,
                                  const input::Registry& registry, int dimension) {
    auto source = std::make_shared<input::Source>();
    source->name = "case.yaml";
    source->text = yaml;
    input::Diagnostics diagnostics;
    const input::Node node = input::readYaml(source, source->text, {}, diagnostics);
    diagnostics.throwIfErrors();
    input::Reader reader(diagnostics, registry);
    reader.dimension = dimension;
    input::Component entry;
    entry.name = "row";
    entry.place = node.place;
    entry.declaration = registry.find(kind, node.find("type")->text);
    std::shared_ptr<void> parameters = entry.declaration->makeParameters();
    input::readParameters(node, node.place, reader, {{entry.declaration, parameters.get()}},
                          {"type"});
    diagnostics.throwIfErrors();
    entry.parameters = parameters;
    for (const auto& given : node.entries)
        entry.parameter_places.emplace_back(given.key, given.value.place);
    return entry;
}

}  // namespace sphinx::test
