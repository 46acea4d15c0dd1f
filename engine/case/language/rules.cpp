// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/rules.h"

namespace sphinx::model {

const MethodBuilder* rulesOf(const input::Declaration& declaration) {
    return declaration.isTimeStep() ? nullptr : &declaration.builder<MethodBuilder>();
}

namespace {
void addLayer(const Case& model, const Layer& layer, WrittenCase& written) {
    WrittenCase::Layer added{layer.name.text, {}, layer.dt.number.has_value(), {}};
    for (const Name& name : layer.dt.methods) added.dt.push_back(model.findMethod(name.text));
    for (const Step& step : layer.steps)
        if (!step.layer) added.called.push_back(model.findMethod(step.method()));
    written.layers.push_back(std::move(added));
    for (const Step& step : layer.steps)
        if (step.layer) addLayer(model, *step.layer, written);
}
}  // namespace

WrittenCase writtenCase(const Case& model, input::Diagnostics& diagnostics) {
    WrittenCase written{model.loop.start_time, &model.units, {}, {}, {}, {}, {}, diagnostics};
    for (const Component& method : model.dynamics) {
        written.methods.push_back(&method);
        if (model.calls(method.name)) written.called.push_back(&method);
    }
    addLayer(model, model.loop, written);
    for (const Sight& sight : model.topology)
        for (const Contact& contact : sight.sees)
            written.topology.push_back({sight.body.text, contact.body.text, contact.bonded});
    for (const Body& body : model.bodies)
        if (!body.material.empty())
            written.materials[body.name] = model.findMaterial(body.material.text);
    return written;
}

void checkRules(const Case& model, input::Diagnostics& diagnostics) {
    WrittenCase written = writtenCase(model, diagnostics);
    for (const Component& method : model.dynamics)
        if (const MethodBuilder* of = rulesOf(*method.declaration))
            for (const Rule rule : of->rules) rule(method, written);
}

}  // namespace sphinx::model
