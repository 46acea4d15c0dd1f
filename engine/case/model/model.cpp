// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/model/model.h"

#include "case/model/smoothing.h"

#include <cmath>

namespace sphinx::model {

std::pair<std::string, std::string> splitAction(const std::string& text) {
    const auto dot = text.find('.');
    if (dot == std::string::npos) return {text, ""};
    return {text.substr(0, dot), text.substr(dot + 1)};
}

double Body::spacing(const Resolution& reference) const {
    return resolution.spacing ? *resolution.spacing
                              : std::ldexp(reference.spacing, -resolution.level);
}

double Body::smoothingRatio(const Resolution& reference) const {
    if (resolution.smoothing_ratio) return *resolution.smoothing_ratio;
    if (reference.smoothing_ratio) return *reference.smoothing_ratio;
    return defaultSmoothingRatio(role, kernel(reference));
}

kernels::KernelType Body::kernel(const Resolution& reference) const {
    if (reference.kernel) return *reference.kernel;
    return defaultKernel(role, reference.smoothing_ratio || resolution.smoothing_ratio);
}

namespace {
template <class Entries>
auto findByName(const Entries& entries, std::string_view name) -> decltype(entries.data()) {
    for (const auto& entry : entries)
        if (entry.name == name) return &entry;
    return nullptr;
}

bool callsIn(const std::vector<Step>& steps, std::string_view method);
bool callsIn(const Layer& layer, std::string_view method) {
    for (const Name& name : layer.dt.methods)
        if (name.text == method) return true;
    return callsIn(layer.steps, method);
}
bool callsIn(const std::vector<Step>& steps, std::string_view method) {
    for (const Step& step : steps)
        if (step.layer ? callsIn(*step.layer, method) : step.method() == method) return true;
    return false;
}
}  // namespace

const Shape* Case::findShape(std::string_view name) const { return findByName(shapes, name); }
const Body* Case::findBody(std::string_view name) const { return findByName(bodies, name); }
const Component* Case::findMaterial(std::string_view name) const {
    return findByName(materials, name);
}
const Component* Case::findMethod(std::string_view name) const {
    return findByName(dynamics, name);
}

bool Case::calls(std::string_view method) const {
    return callsIn(loop.start, method) || callsIn(loop, method);
}

bool Case::responds(const Body& body) const {
    if (body.role == bodies::Role::elastic) return true;
    return body.role == bodies::Role::wall && multibody && multibody->carries(body.name);
}

const std::vector<Seen>& Case::seenBy(std::string_view body) const {
    static const std::vector<Seen> nothing;
    for (const Sight& sight : topology)
        if (sight.body.text == body) return sight.sees;
    return nothing;
}

}  // namespace sphinx::model
