// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "loop/run/layer_run.h"

#include "core/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sphinx::loop {

double triggerTime(double time, double dt) { return time + rounding_part * dt; }

LayerRun::LayerRun(const Layer& layer, double start_time) : LayerRun(layer, start_time, nullptr) {
    connectTriggers(*this);
}

LayerRun::LayerRun(const Layer& layer, double start_time, LayerRun* parent)
    : layer_(layer), parent_(parent), laps_(parent ? parent->laps_ : own_laps_) {
    clock_.time = start_time;
    estimate_tallies_.resize(layer.dt.size());
    for (const Step& step : layer.steps) {
        if (const auto* call = std::get_if<Call>(&step.value)) {
            CallRun line;
            line.call = call;
            if (call->every) {
                line.every.emplace(call->every->interval);
                if (call->every->kind == Trigger::Kind::time) line.every->startAfter(start_time);
            }
            lines_.emplace_back(std::move(line));
        } else {
            lines_.emplace_back(std::unique_ptr<LayerRun>(
                new LayerRun(std::get<Layer>(step.value), start_time, this)));
        }
    }
}

void LayerRun::connectTriggers(LayerRun& outermost) {
    for (Line& line : lines_) {
        if (auto* inner = std::get_if<std::unique_ptr<LayerRun>>(&line)) {
            (*inner)->connectTriggers(outermost);
            continue;
        }
        auto& call = std::get<CallRun>(line);
        if (!call.every) continue;
        call.counting = outermost.find(call.call->every->layer);
        call.under_way = isInside(call.counting);
    }
}

bool LayerRun::isInside(const LayerRun* other) const {
    return this == other || (parent_ && parent_->isInside(other));
}

LayerRun* LayerRun::find(std::string_view name) {
    if (name.empty() || name == layer_.name) return this;
    for (Line& line : lines_)
        if (auto* inner = std::get_if<std::unique_ptr<LayerRun>>(&line))
            if (LayerRun* found = (*inner)->find(name)) return found;
    return nullptr;
}

void LayerRun::sampleSubsteps(std::function<void(const Clock&)> sampler) {
    samplers_.push_back(std::move(sampler));
}

void LayerRun::sample() {
    Tally cost;
    {
        const TimedCall timed(cost);
        for (const auto& sampler : samplers_) sampler(clock_);
    }
    for (LayerRun* layer = this; layer; layer = layer->parent_)
        layer->tally_.nanoseconds -= cost.nanoseconds;
    laps_.begin();
}

void LayerRun::count(std::int64_t began) {
    ++tally_.calls;
    tally_.nanoseconds += laps_.last() - began;
}

void LayerRun::fail(const std::string& message) const {
    throw PhysicsError(fmt::format("{} at time {} (layer {}, after {} substeps)", message,
                                   clock_.time, layer_.name, clock_.steps));
}

double LayerRun::estimate() {
    double smallest = layer_.fixed_dt.value_or(std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < layer_.dt.size(); ++k) {
        const TimeStep& step = layer_.dt[k];
        Tally& tally = estimate_tallies_[k];
        const double dt = step.method->estimate();
        laps_.end(tally);
        tally.particles += static_cast<double>(step.method->workSize());
        if (!(std::isfinite(dt) && dt > 0))
            fail(fmt::format("{} gives a time step of {}", step.label, dt));
        smallest = std::min(smallest, dt);
    }
    return smallest;
}

void LayerRun::stepFreely() {
    laps_.begin();
    const std::int64_t began = laps_.last();
    const double dt = estimate();
    if (!(clock_.time + dt > clock_.time))
        fail(fmt::format("a time step of {} is too small to advance the time", dt));
    clock_.interval_start = clock_.time;
    substep(dt, clock_.time + dt);
    count(began);
}

double LayerRun::cover(double from, double until) {
    clock_.time = clock_.interval_start = from;
    do {
        if (watch_) watch_();
        const std::int64_t began = laps_.last();
        const Substep next = fitSubstep(layer_.fit, clock_.time, until, estimate());
        if (!(next.end > clock_.time))
            fail(fmt::format("a time step of {} is too small to advance the time", next.dt));
        substep(next.dt, next.end);
        count(began);
    } while (!reached(clock_.time, layer_.fit == Fit::overshoot ? clock_.dt : 0, until));
    return clock_.time;
}

void LayerRun::substep(double dt, double end) {
    clock_.dt = dt;
    begin_ = triggerTime(clock_.time, dt);
    endWindows();
    for (Line& line : lines_) {
        if (auto* call = std::get_if<CallRun>(&line)) {
            run(*call);
            continue;
        }
        LayerRun& inner = *std::get<std::unique_ptr<LayerRun>>(line);
        const double covered = inner.cover(clock_.time, end);
        if (inner.layer_.fit == Fit::overshoot) {
            end = covered;
            clock_.dt = end - clock_.time;
        }
    }
    clock_.time = end;
    ++clock_.steps;
    if (!samplers_.empty()) sample();
}

void LayerRun::endWindows() {
    for (Line& line : lines_) {
        auto* call = std::get_if<CallRun>(&line);
        if (!call || !call->to_rest || call->call->window.holds(begin_)) continue;
        call->call->method->rest();
        call->to_rest = false;
    }
}

bool LayerRun::due(CallRun& line) const {
    if (!line.every) return true;
    if (line.call->every->kind == Trigger::Kind::time)
        return line.every->reach(triggerTime(clock_.time + clock_.dt, clock_.dt));
    const std::int64_t steps = line.counting->clock_.steps + (line.under_way ? 1 : 0);
    return line.every->reach(static_cast<double>(steps));
}

void LayerRun::run(CallRun& line) {
    // Asked in any case: multiples that pass outside of the window are past.
    const bool is_due = due(line);
    if (!is_due || !line.call->window.holds(begin_)) return;
    line.call->act(clock_);
    laps_.end(line.tally);
    line.tally.particles += static_cast<double>(line.call->method->workSize());
    if (line.call->window.until) line.to_rest = true;
}

void LayerRun::watchSubsteps(const std::function<void()>& watch) {
    for (Line& line : lines_)
        if (auto* inner = std::get_if<std::unique_ptr<LayerRun>>(&line)) {
            (*inner)->watch_ = watch;
            (*inner)->watchSubsteps(watch);
        }
}

void LayerRun::transfer(Archive& archive) {
    {
        const Section section(archive, layer_.name);
        clock_.transfer(archive);
        int triggers = 0;
        int windows = 0;
        for (Line& line : lines_) {
            auto* call = std::get_if<CallRun>(&line);
            if (call && call->every) {
                const Section every(archive, fmt::format("every_{}", triggers++));
                call->every->transfer(archive);
            }
            if (call && call->call->window.until)
                archive.value(fmt::format("to_rest_{}", windows++), call->to_rest);
        }
    }
    for (Line& line : lines_)
        if (auto* inner = std::get_if<std::unique_ptr<LayerRun>>(&line))
            (*inner)->transfer(archive);
}

}  // namespace sphinx::loop
