// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../io/support.h"
#include "../scene/outputs.h"
#include "input/declaration/reader.h"
#include "input/tree/yaml.h"
#include "measure/register.h"

#include <memory>
#include <string>

namespace sphinx::test {

/// An entry of `outputs` as the case file writes it: "{type: ..., ...}".
class Entry {
 public:
    explicit Entry(const std::string& yaml, int dimension = 2) {
        measure::registerMeasures(registry_);
        auto source = std::make_shared<input::Source>();
        source->name = "case.yaml";
        source->text = yaml;
        input::Diagnostics diagnostics;
        const input::Node node = input::readYaml(source, source->text, {}, diagnostics);
        diagnostics.throwIfErrors();
        input::Reader reader(diagnostics, registry_);
        reader.dimension = dimension;
        component_.name = "row";
        component_.place = node.place;
        component_.declaration = registry_.find(input::Kind::output, node.find("type")->text);
        std::shared_ptr<void> parameters = component_.declaration->makeParameters();
        input::readParameters(node, node.place, reader,
                              {{component_.declaration, parameters.get()}}, {"type"});
        diagnostics.throwIfErrors();
        component_.parameters = parameters;
        for (const auto& entry : node.entries)
            component_.parameter_places.emplace_back(entry.key, entry.value.place);
    }
    template <int Dim>
    std::unique_ptr<Output> make(const io::OutputContext<Dim>& context) const {
        return component_.declaration->builder<io::OutputFactory>().make(component_, context);
    }

 private:
    input::Registry registry_;
    input::Component component_;
};

}  // namespace sphinx::test
