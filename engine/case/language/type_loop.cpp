// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/types.h"

#include "input/declaration/reader.h"
#include "input/declaration/schema.h"

#include <algorithm>

namespace sphinx::language {
namespace {

using namespace input;

struct EveryKeys {
    std::optional<double> time;
    std::optional<std::int64_t> steps;
    Name layer;
    std::optional<double> wall_time;
};

class EveryType final : public TypeBase {
 public:
    explicit EveryType(const Declaration& keys) : keys_(keys) {}

    bool read(const Node& node, Reader& reader, void* out) const override {
        EveryKeys keys;
        if (!readParameters(node, node.place, reader, {{&keys_, &keys}})) return false;
        auto& every = *static_cast<Every*>(out);
        every = {};
        if (keys.time) every.by = Every::By::time, every.time = *keys.time;
        if (keys.steps) every.by = Every::By::steps, every.steps = *keys.steps;
        if (keys.wall_time) every.by = Every::By::wall_time, every.wall_seconds = *keys.wall_time;
        every.layer = keys.layer;
        return true;
    }
    Node write(const void* value, const Node* source) const override {
        const auto& every = *static_cast<const Every*>(value);
        EveryKeys keys;
        if (every.by == Every::By::time) keys.time = every.time;
        if (every.by == Every::By::steps) keys.steps = every.steps;
        if (every.by == Every::By::wall_time) keys.wall_time = every.wall_seconds;
        keys.layer = every.layer;
        return writeStructure(keys_, &keys, source);
    }
    Node schema(SchemaBuilder& builder) const override {
        return builder.define("every", [&] { return builder.object(keys_); });
    }
    std::string text() const override {
        return "{time: T} | {steps: N} | {wall_time: 30 min}, see 'every'";
    }

 private:
    const Declaration& keys_;
};

class TimeStepType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& dt = *static_cast<model::TimeStep*>(out);
        dt = {};
        if (!node.isList()) return readOne(node, reader, dt);
        bool good = true;
        for (const Node& item : node.items) good = readOne(item, reader, dt) && good;
        if (node.items.empty()) return reader.error(node, "dt is an empty list");
        return good;
    }
    Node write(const void* value, const Node* source) const override {
        const auto& dt = *static_cast<const model::TimeStep*>(value);
        const Place place = source ? source->place : Place{};
        Node list = Node::list().at(place);
        for (const Name& method : dt.methods) list.add(Node::plain(method.text).at(place));
        if (dt.number) list.add(Node::number(*dt.number).at(place));
        return list.items.size() == 1 ? list.items.front() : list;
    }
    Node schema(SchemaBuilder&) const override {
        Node schema = Node::map();
        schema.set("type", Node::list({Node::string("string"), Node::string("number"),
                                       Node::string("array")}));
        schema.set("exclusiveMinimum", Node::integer(0));
        Node item = Node::map();
        item.set("type", Node::list({Node::string("string"), Node::string("number")}));
        schema.set("items", std::move(item));
        schema.set("minItems", Node::integer(1));
        return schema;
    }
    std::string text() const override {
        return "name of a time-step method | number, time | list of them, whose smallest counts";
    }

 private:
    static bool readOne(const Node& node, Reader& reader, model::TimeStep& dt) {
        // A word that names no variable is a method; its spelling is checked with the names.
        const bool word = node.isScalar() && !node.text.empty() &&
                          std::all_of(node.text.begin(), node.text.end(),
                                      [](char c) {
                                          return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                                 (c >= '0' && c <= '9') || c == '_';
                                      }) &&
                          !(node.text[0] >= '0' && node.text[0] <= '9');
        const bool method = word && (!reader.scope.has(node.text) || reader.hasMethod(node.text));
        if (method) {
            dt.methods.push_back({node.text, node.place});
            reader.references.push_back(
                {Target::method, {"time_step"}, dt.methods.back(), reader.label});
            return true;
        }
        double number = 0;
        if (!Type<double>(input::number(unit::time).above(0)).base()->read(node, reader, &number))
            return false;
        dt.number = dt.number ? std::min(*dt.number, number) : number;
        return true;
    }
};

class StepType final : public TypeBase {
 public:
    bool read(const Node& node, Reader& reader, void* out) const override {
        auto& step = *static_cast<model::Step*>(out);
        const auto block = [&](const char* name) {
            return reader.registry.find(Kind::block, name);
        };
        if (node.isScalar()) return actionReference().base()->read(node, reader, &step.run);
        if (node.find("layer")) {
            step.layer = std::make_shared<model::Layer>();
            const Label label(reader, node.find("layer")->text);
            return readParameters(node, node.place, reader, {{block("layer"), step.layer.get()}});
        }
        if (node.find("run")) {
            const Label label(reader, "run");
            return readParameters(node, node.place, reader, {{block("run"), &step}});
        }
        return reader.mismatch(
            node,
            "METHOD, METHOD.ACTION, {run: METHOD, "
            "every: ..., from: ..., until: ...} or {layer: NAME, dt: ..., steps: [...]}");
    }
    Node write(const void* value, const Node* source) const override {
        const auto& step = *static_cast<const model::Step*>(value);
        const Place place = source ? source->place : Place{};
        if (step.layer) return writeStructure(*registryBlock("layer"), step.layer.get(), source);
        if (!step.every && !step.window().limited()) return Node::plain(step.run.text).at(place);
        return writeStructure(*registryBlock("run"), &step, source);
    }
    Node schema(SchemaBuilder& builder) const override {
        return builder.define("step", [&] {
            const Registry& registry = builder.registry;
            Node layer = builder.define(
                "layer", [&] { return builder.object(*registry.find(Kind::block, "layer")); });
            Node run = builder.define(
                "run", [&] { return builder.object(*registry.find(Kind::block, "run")); });
            Node required = Node::map();
            required.set("required", Node::list({Node::string("layer")}));
            Node object = Node::map();
            object.set("if", std::move(required));
            object.set("then", std::move(layer));
            object.set("else", std::move(run));
            Node schema = Node::map();
            schema.set("type", Node::list({Node::string("string"), Node::string("object")}));
            schema.set("if", schemaType("object"));
            schema.set("then", std::move(object));
            return schema;
        });
    }
    std::string text() const override {
        return "METHOD | METHOD.ACTION | {run: METHOD, every: ..., from: T, until: T} | a nested "
               "layer, see 'layer'";
    }

    explicit StepType(const Registry& registry) : registry_(registry) {}

 private:
    const Declaration* registryBlock(const char* name) const {
        return registry_.find(Kind::block, name);
    }
    const Registry& registry_;
};

}  // namespace

void declareEvery(Registry& registry) {
    using P = EveryKeys;
    auto& d = registry.declare<P>(Kind::block, "every");
    d.summary("How often something happens besides the start and the end; exactly one interval");
    d.optional("time", &P::time, number(unit::time).above(0), "interval of simulated time");
    d.optional("steps", &P::steps, integer().atLeast(1), "interval in steps of a layer");
    d.optional(
        "layer", &P::layer, layerReference(),
        "layer whose steps count; default: the outermost. An output is written at the end of an "
        "outermost step");
    d.optional("wall_time", &P::wall_time, wallSeconds(), "interval on the clock on the wall");
    d.check("", [](const P& p) -> std::string {
        const int given = p.time.has_value() + p.steps.has_value() + p.wall_time.has_value();
        return given == 1 ? "" : "every needs exactly one of time, steps and wall_time";
    });
    d.check("layer", [](const P& p) -> std::string {
        return p.layer.empty() || p.steps ? "" : "layer goes with steps";
    });
}

Type<Every> every(const Registry& registry) {
    return Type<Every>(std::make_shared<EveryType>(*registry.find(Kind::block, "every")));
}
Type<model::TimeStep> timeStep() { return Type<model::TimeStep>(std::make_shared<TimeStepType>()); }
Type<model::Step> step(const Registry& registry) {
    return Type<model::Step>(std::make_shared<StepType>(registry));
}

}  // namespace sphinx::language
