// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/rules.h"

namespace sphinx::language {

const dynamics::MethodBuilder* rulesOf(const input::Declaration& declaration) {
    return declaration.isTimeStep() ? nullptr : &declaration.builder<dynamics::MethodBuilder>();
}

namespace {
void addLayer(const model::Case& model, const model::Layer& layer, dynamics::WrittenCase& written) {
    dynamics::WrittenCase::Layer added{layer.name.text, {}, layer.dt.number.has_value(), {}};
    for (const input::Name& name : layer.dt.methods)
        added.dt.push_back(model.findMethod(name.text));
    for (const model::Step& step : layer.steps)
        if (!step.layer) added.called.push_back(model.findMethod(step.method()));
    written.layers.push_back(std::move(added));
    for (const model::Step& step : layer.steps)
        if (step.layer) addLayer(model, *step.layer, written);
}
}  // namespace

dynamics::WrittenCase writtenCase(const model::Case& model, input::Diagnostics& diagnostics) {
    dynamics::WrittenCase written{.start_time = model.loop.start_time,
                                  .end_time = model.loop.end_time,
                                  .multibody = model.multibody ? &*model.multibody : nullptr,
                                  .carried = {},
                                  .moved = {},
                                  .methods = {},
                                  .called = {},
                                  .layers = {},
                                  .topology = {},
                                  .materials = {},
                                  .places = {},
                                  .diagnostics = diagnostics};
    for (const input::Component& method : model.dynamics) {
        written.methods.push_back(&method);
        if (model.calls(method.name)) written.called.push_back(&method);
    }
    for (const model::Body& body : model.bodies)
        if (body.role == bodies::Role::wall && model.responds(body))
            written.carried.push_back(body.name);
    if (model.multibody)
        for (const auto& [name, body] : model.multibody->bodies)
            for (const input::Name& part : body.particles) written.moved.push_back(part.text);
    addLayer(model, model.loop, written);
    for (const model::Sight& sight : model.topology)
        for (const model::Seen& seen : sight.sees)
            written.topology.push_back({sight.body, seen.body, seen.as == model::SeenAs::bonded,
                                        seen.as == model::SeenAs::contact});
    for (const model::Body& body : model.bodies) written.places[body.name] = body.place;
    for (const model::Body& body : model.bodies)
        if (!body.material.empty())
            written.materials[body.name] = model.findMaterial(body.material.text);
    return written;
}

void checkRules(const model::Case& model, input::Diagnostics& diagnostics) {
    dynamics::WrittenCase written = writtenCase(model, diagnostics);
    for (const input::Component& method : model.dynamics)
        if (const dynamics::MethodBuilder* of = rulesOf(*method.declaration))
            for (const dynamics::Rule rule : of->rules) rule(method, written);
}

}  // namespace sphinx::language
