// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/plan/plan.h"

#include <cmath>
#include <set>
#include <stdexcept>

namespace sphinx::loop {
namespace {

void require(bool condition, const std::string& message) {
    if (!condition) throw std::invalid_argument("loop: " + message);
}

void collectNames(const Layer& layer, std::set<std::string>& names) {
    require(!layer.name.empty(), "a layer has no name");
    require(names.insert(layer.name).second, "two layers are called " + layer.name);
    for (const Step& step : layer.steps)
        if (const auto* inner = std::get_if<Layer>(&step.value)) collectNames(*inner, names);
}

void validateTrigger(const Trigger& trigger, const std::string& owner,
                     const std::set<std::string>& layers) {
    const double interval = trigger.interval;
    require(std::isfinite(interval) && interval > 0, owner + ": the interval must be above 0");
    if (trigger.kind == Trigger::Kind::steps)
        require(interval == std::floor(interval), owner + ": steps must be a whole number");
    require(trigger.layer.empty() ||
                (trigger.kind == Trigger::Kind::steps && layers.count(trigger.layer) > 0),
            owner + ": no layer " + trigger.layer + " to count steps of");
}

void validateCall(const Call& call, const std::set<std::string>& layers) {
    require(call.method && call.action, call.label + " has no method");
    const Window& window = call.window;
    require(!window.from || !window.until || *window.from < *window.until,
            call.label + ": the end of its time must be above the start");
    if (!call.every) return;
    require(call.every->kind != Trigger::Kind::wall_time,
            call.label + ": a call cannot depend on the wall time");
    validateTrigger(*call.every, call.label, layers);
}

/// `may_extend`: whether the layer's interval may become longer than planned.
void validateLayer(const Layer& layer, bool may_extend, const std::set<std::string>& layers) {
    require(!layer.dt.empty() || layer.fixed_dt, "layer " + layer.name + " has no dt");
    if (layer.fixed_dt)
        require(std::isfinite(*layer.fixed_dt) && *layer.fixed_dt > 0,
                "layer " + layer.name + ": dt must be above 0");
    for (const TimeStep& step : layer.dt)
        require(step.method != nullptr, step.label + " has no method");
    bool first = true;
    for (const Step& step : layer.steps) {
        if (const auto* call = std::get_if<Call>(&step.value)) {
            validateCall(*call, layers);
            continue;
        }
        const auto& inner = std::get<Layer>(step.value);
        if (inner.fit == Fit::overshoot)
            require(may_extend && first,
                    "layer " + inner.name + " overshoots where its parent cannot follow");
        validateLayer(inner, inner.fit == Fit::overshoot, layers);
        first = false;
    }
}

}  // namespace

void validate(const Plan& plan) {
    require(std::isfinite(plan.start_time) && std::isfinite(plan.end_time),
            "start and end time must be finite");
    std::set<std::string> layers;
    collectNames(plan.outermost, layers);
    validateLayer(plan.outermost, true, layers);
    for (const Call& call : plan.start) {
        validateCall(call, layers);
        require(!call.every && !call.window.limited(), call.label + ": a start call runs once");
    }
    std::set<std::string> names;
    for (const OutputEntry& entry : plan.outputs) {
        require(entry.output != nullptr, "output " + entry.name + " has no object");
        require(names.insert(entry.name).second, "two outputs are called " + entry.name);
        if (entry.every) validateTrigger(*entry.every, "output " + entry.name, layers);
        const std::optional<std::string> sampled = entry.output->sampledLayer();
        require(!sampled || sampled->empty() || layers.count(*sampled) > 0,
                "output " + entry.name + ": no layer " + sampled.value_or("") + " to sample");
    }
}

}  // namespace sphinx::loop
