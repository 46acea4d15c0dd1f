// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/phases.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace sphinx::language {
namespace {

using namespace input;

class SenseCheck {
 public:
    SenseCheck(const CaseBlock& block, const UnitSystem& units, Diagnostics& diagnostics)
        : block_(block), time_unit_(units.suffix(unit::time)), diagnostics_(diagnostics) {}

    void run() {
        if (block_.bodies.empty())
            diagnostics_.error(block_.loop.name.place, "the case has no bodies");
        for (const NamedBody& body : block_.bodies) {
            if (body.block.kind == BodyKind::observer)
                checkObserver(body);
            else
                checkMaterialBody(body);
            checkParts(body);
        }
        checkPeriodic();
        checkTopology();
        for (const Component& method : block_.dynamics) checkSight(method);
        checkLayer(block_.loop);
        checkSteps(block_.loop.start, "start");
        for (const model::Step& step : block_.loop.start) {
            if (step.every)
                diagnostics_.error(step.run.place, "start happens once: 'every' has no meaning");
            if (step.window().limited())
                diagnostics_.error(step.run.place, std::string("start happens once: '") +
                                                       (step.from ? "from" : "until") +
                                                       "' has no meaning");
        }
    }

 private:
    static const Place* given(const NamedBody& body, std::string_view key) {
        for (const auto& [name, place] : body.given)
            if (name == key) return &place;
        return nullptr;
    }
    void refuse(const NamedBody& body, std::initializer_list<const char*> keys,
                const std::string& why) {
        for (const char* key : keys)
            if (const Place* place = given(body, key))
                diagnostics_.error(*place, std::string("'") + key + "' is for " + why);
    }

    void checkObserver(const NamedBody& body) {
        refuse(body,
               {"shape", "material", "particles", "arrangement", "resolution", "initial", "parts"},
               "fluids and solids; an observer has points, line or area");
        const BodyBlock& b = body.block;
        if (b.points.has_value() + b.line.has_value() + b.area.has_value() != 1)
            diagnostics_.error(body.place, "the observer '" + body.name +
                                               "' needs exactly one of points, line and area");
        if (b.points && b.points->rows.empty())
            diagnostics_.error(*given(body, "points"), "points is empty");
        if (b.area) checkArea(body, *b.area);
    }

    void checkArea(const NamedBody& body, const AreaBlock& area) {
        const std::size_t edges = block_.dimension == 2 ? 1 : 2;
        if (area.edges.rows.size() != edges || area.points.size() != edges)
            diagnostics_.error(*given(body, "area"),
                               "an area in " + std::to_string(block_.dimension) + "D has " +
                                   std::to_string(edges) + (edges == 1 ? " edge" : " edges") +
                                   " and as many numbers of points");
    }

    void checkMaterialBody(const NamedBody& body) {
        refuse(body, {"points", "line", "area", "follows"}, "observers");
        const BodyBlock& b = body.block;
        const bool fluid = b.kind == BodyKind::fluid;
        if (b.material.empty())
            diagnostics_.error(body.place, body.name + " lacks 'material': a " +
                                               (fluid ? "fluid" : "solid") + " needs one");
        if (b.shape.empty() && !b.particles)
            diagnostics_.error(body.place, body.name + " lacks 'shape' (or 'particles')");
        if (b.particles && b.particles->rows.empty())
            diagnostics_.error(*given(body, "particles"), "particles is empty");
        if (b.particles)
            refuse(body, {"arrangement"}, "bodies whose particles are made in a shape");
        if (b.arrangement == model::Arrangement::jittered && !fluid)
            diagnostics_.error(*given(body, "arrangement"),
                               "jittered is for fluids, whose particles find their places");
        if (b.initial && b.initial->pressure && !fluid)
            diagnostics_.error(*given(body, "initial"), "only a fluid has an initial pressure");
    }

    void checkParts(const NamedBody& body) {
        if (body.block.shape.empty()) return;
        for (const auto& [part, shape] : body.block.parts)
            if (shape.text == body.block.shape.text)
                diagnostics_.error(shape.place, "the part '" + part.text +
                                                    "' is the whole body; name the body instead");
    }

    void checkPeriodic() {
        const auto& domain = block_.domain;
        if (!domain.periodic.empty() && !(domain.lower && domain.upper))
            diagnostics_.error(domain.place,
                               "a periodic domain needs 'lower' and 'upper': they are the period");
    }

    void checkTopology() {
        for (const auto& [body, sees] : block_.topology) {
            std::set<std::pair<std::string, bool>> listed;
            for (const model::Seen& seen : sees) {
                const bool self = seen.body.text == "self";
                if (seen.body.text == body.text)
                    diagnostics_.error(seen.body.place, "a body sees itself by the word self");
                if (self && kindOf(body.text) == BodyKind::observer)
                    diagnostics_.error(seen.body.place, "an observer has nothing to see of itself");
                checkPair(body, seen);
                const bool contact = seen.as == model::SeenAs::contact;
                if (!listed.emplace(seen.body.text, contact).second)
                    diagnostics_.error(seen.body.place,
                                       "'" + seen.body.text + "' is listed twice for " + body.text);
            }
        }
    }
    void checkPair(const Name& body, const model::Seen& seen) {
        const std::string& name = seen.body.text == "self" ? body.text : seen.body.text;
        const BodyKind one = kindOf(body.text);
        const BodyKind other = kindOf(name);
        const auto wantSolids = [&](const char* what) {
            const bool first = one != BodyKind::solid;
            if (!first && other == BodyKind::solid) return;
            const bool fluid = (first ? one : other) == BodyKind::fluid;
            diagnostics_.error(seen.body.place,
                               fmt::format("{}: {} is {}", what, first ? body.text : name,
                                           fluid ? "a fluid" : "an observer"));
        };
        if (seen.as == model::SeenAs::contact) return wantSolids("contact is between solids");
        if (name == body.text) return;
        if (one == BodyKind::fluid && other == BodyKind::fluid && !sees(name, body.text))
            diagnostics_.error(seen.body.place,
                               fmt::format("{0} sees {1}, but {1} does not see {0}: fluids push "
                                           "each other, so the topology of {1} needs {0}",
                                           body.text, name));
        if (one == BodyKind::solid && other == BodyKind::solid && seen.as == model::SeenAs::flow)
            diagnostics_.error(seen.body.place,
                               fmt::format("{0} and {1} are both solids: '{{contact: {1}}}' keeps "
                                           "them apart, '{{bonded: {1}}}' makes them one piece",
                                           body.text, name));
        if (seen.as == model::SeenAs::bonded) wantSolids("only solids are bonded to each other");
    }
    /// Methods act on what topology lets a body see.
    void checkSight(const Component& method) {
        const std::string& type = method.declaration->name();
        if (!method.declaration->hasTrait("sums_over_itself")) return;
        for (const char* parameter : {"body", "bodies"})
            for (const Name& body : method.references(parameter))
                if (!sees(body.text, "self") && !sees(body.text, body.text))
                    diagnostics_.error(body.place,
                                       fmt::format("{} sums over the particles of {} itself: its "
                                                   "topology lacks 'self'",
                                                   type, body.text));
    }
    bool sees(const std::string& body, const std::string& other) const {
        for (const auto& [name, sees] : block_.topology)
            if (name.text == body)
                for (const model::Seen& seen : sees)
                    if (seen.as != model::SeenAs::contact && seen.body.text == other) return true;
        return false;
    }
    BodyKind kindOf(const std::string& name) const {
        for (const NamedBody& body : block_.bodies)
            if (body.name == name) return body.block.kind;
        return BodyKind::fluid;
    }

    void checkLayer(const model::Layer& layer) {
        if (!layers_.insert(layer.name.text).second)
            diagnostics_.error(layer.name.place, "there are two layers '" + layer.name.text + "'");
        if (layer.steps.empty())
            diagnostics_.error(layer.name.place,
                               "the layer '" + layer.name.text + "' has no steps");
        checkSteps(layer.steps, "");
        for (const model::Step& step : layer.steps)
            if (step.layer)
                checkLayer(*step.layer);
            else {
                checkWindow(step);
                checkThroughout(step);
            }
    }
    void checkThroughout(const model::Step& step) {
        const auto [name, action] = model::splitAction(step.run.text);
        const std::string key = step.every ? "every" : step.from ? "from" : "until";
        if (!step.every && !step.window().limited()) return;
        for (const Component& method : block_.dynamics) {
            if (method.name != name) continue;
            const Declaration& declaration = *method.declaration;
            const std::string& why =
                declaration.actions()[declaration.actionIndex(action)].throughout();
            if (!why.empty())
                diagnostics_.error(step.run.place,
                                   fmt::format("'{}' is not for {}: {}", key, step.run.text, why));
        }
    }
    void checkWindow(const model::Step& step) {
        const double start = block_.loop.start_time;
        if (step.from && *step.from < start)
            diagnostics_.error(step.run.place,
                               fmt::format("from is {0}{2} but must be at least start_time, {1}{2}",
                                           *step.from, start, time_unit_));
        if (step.until && *step.until <= start)
            diagnostics_.error(
                step.run.place,
                fmt::format(
                    "until is {0}{3} but must be above start_time, {1}{3}: {2} would never act",
                    *step.until, start, step.run.text, time_unit_));
    }
    void checkSteps(const std::vector<model::Step>& steps, const std::string& where) {
        for (const model::Step& step : steps) {
            if (step.layer && !where.empty())
                diagnostics_.error(step.layer->name.place, "start has no layers");
            if (step.every && step.every->by == Every::By::wall_time)
                diagnostics_.error(step.run.place,
                                   "wall_time is for outputs: the physics cannot depend on the "
                                   "speed of the machine");
        }
    }

    const CaseBlock& block_;
    const std::string time_unit_;
    Diagnostics& diagnostics_;
    std::set<std::string> layers_;
};

}  // namespace

void checkSense(const CaseBlock& block, const UnitSystem& units, Diagnostics& diagnostics) {
    SenseCheck(block, units, diagnostics).run();
}

}  // namespace sphinx::language
