// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/phases.h"
#include "input/tree/suggest.h"
#include "particles/fields.h"

#include <algorithm>
#include <map>
#include <set>

namespace sphinx::language {
namespace {

using namespace input;
using Words = std::vector<std::string>;

template <class Entries>
Words namesOf(const Entries& entries) {
    Words names;
    for (const auto& entry : entries) names.push_back(entry.name);
    return names;
}

void collectLayers(const model::Layer& layer, Words& names) {
    names.push_back(layer.name.text);
    for (const model::Step& step : layer.steps)
        if (step.layer) collectLayers(*step.layer, names);
}

bool intersects(const Words& a, const Words& b) {
    return std::any_of(a.begin(), a.end(), [&](const std::string& word) {
        return std::find(b.begin(), b.end(), word) != b.end();
    });
}

class NameCheck {
 public:
    NameCheck(const CaseBlock& block, const Node& root, Reader& reader)
        : block_(block), reader_(reader) {
        known_[Target::body] = namesOf(block.bodies);
        known_[Target::material] = namesOf(block.materials);
        known_[Target::shape] = namesOf(block.geometry);
        known_[Target::method] = namesOf(block.dynamics);
        collectLayers(block.loop, known_[Target::layer]);
        if (block.multibody) {
            for (const auto& [name, body] : block.multibody->bodies)
                known_[Target::rigid_body].push_back(name.text);
            known_[Target::joint] = namesOf(block.multibody->joints);
            known_[Target::multibody_force] = namesOf(block.multibody->forces);
        }
        for (const particles::FieldInfo* field : fields::all())
            known_[Target::field].emplace_back(field->name);
        for (const auto& [target, key] : blocks)
            if (isSpoilt(root, key)) spoilt_.insert(target);
        if (root.find("multibody") && !block.multibody)
            spoilt_.insert({Target::rigid_body, Target::joint, Target::multibody_force});
        for (const NamedBody& body : block.bodies)
            if (body.good) judgeBody(body);
    }

    void check(const Reference& reference) {
        switch (reference.target) {
            case Target::body:
                if (exists(reference, Target::body, reference.name.text, "body"))
                    checkTraits(reference, reference.name.text);
                break;
            case Target::part: checkPart(reference); break;
            case Target::material:
                if (exists(reference, Target::material, reference.name.text, "material"))
                    checkMaterial(reference);
                break;
            case Target::shape:
                exists(reference, Target::shape, reference.name.text, "shape");
                break;
            case Target::method:
                if (exists(reference, Target::method, reference.name.text, "method"))
                    checkMethod(reference);
                break;
            case Target::action: checkAction(reference); break;
            case Target::layer:
                exists(reference, Target::layer, reference.name.text, "layer");
                break;
            case Target::field:
                exists(reference, Target::field, reference.name.text, "field");
                break;
            case Target::rigid_body_or_ground:
                if (reference.name.text == "ground") break;
                [[fallthrough]];
            case Target::rigid_body:
                exists(reference, Target::rigid_body, reference.name.text, "body of multibody");
                break;
            case Target::joint:
                exists(reference, Target::joint, reference.name.text, "joint");
                break;
            case Target::multibody_force:
                exists(reference, Target::multibody_force, reference.name.text,
                       "force of multibody");
                break;
        }
    }

    /// Tells of each name that does not exist, where it stands first.
    void reportMissing() {
        for (auto& [name, missing] : missing_) {
            std::sort(missing.places.begin(), missing.places.end());
            reader_.error(missing.places.front(),
                          missing.message + alsoIn(missing.places) + missing.hint);
        }
    }

 private:
    struct Missing {
        std::string message, hint;
        std::vector<Place> places;
    };
    static constexpr std::pair<Target, const char*> blocks[] = {
        {Target::body, "bodies"},     {Target::material, "materials"},
        {Target::shape, "geometry"},  {Target::method, "dynamics"},
        {Target::layer, "loop"},      {Target::rigid_body, "multibody"},
        {Target::joint, "multibody"}, {Target::multibody_force, "multibody"}};

    /// The block could not be read, for which there is a message: what it defines is not known.
    bool isSpoilt(const Node& root, const std::string& block) const {
        if (const Node* node = root.find(block)) return !node->isMap();
        const Declaration& top = *reader_.registry.find(Kind::block, "case");
        return top.parameter(block)->required ||
               std::any_of(root.entries.begin(), root.entries.end(), [&](const Node::Entry& entry) {
                   return !top.parameter(entry.key) && isNear(entry.key, block);
               });
    }

    /// " (also in line 22)".
    static std::string alsoIn(const std::vector<Place>& places) {
        std::string lines;
        std::size_t count = 0;
        for (std::size_t k = 1; k < places.size(); ++k) {
            if (places[k].source != places[0].source || places[k].line == places[k - 1].line)
                continue;
            lines += (lines.empty() ? "" : ", ") + std::to_string(places[k].line);
            ++count;
        }
        if (count == 0) return "";
        return (count == 1 ? " (also in line " : " (also in lines ") + lines + ")";
    }

    /// What references may ask of it; nothing where its material is not known or not for its kind.
    void judgeBody(const NamedBody& body) {
        const BodyKind kind = body.block.kind;
        const Name& name = body.block.material;
        const Component* material = findComponent(block_.materials, name.text);
        if (!name.empty() && !(material && material->declaration)) return;
        if (material && kind != BodyKind::observer) {
            const bool fluid = kind == BodyKind::fluid;
            if (fluid != material->declaration->hasTrait("fluid")) {
                report(name.place,
                       "'" + body.name + "' is a " + (fluid ? "fluid" : "solid") +
                           ", but the material '" + material->name + "' (" +
                           material->declaration->name() + ") is for " +
                           (fluid ? "solids: give it 'kind: solid' or the material of a fluid"
                                  : "fluids: give it 'kind: fluid' or the material of a solid"));
                return;
            }
        }
        traits_[body.name] = bodyTraits(roleOf(kind, material), material);
    }

    bool report(const Place& place, std::string message) {
        return reader_.error(place, std::move(message));
    }

    bool exists(const Reference& reference, Target target, const std::string& name,
                const std::string& what) {
        const Words& known = known_[target];
        if (std::find(known.begin(), known.end(), name) != known.end()) return true;
        if (spoilt_.contains(target)) return false;
        const Place& place = reference.name.place;
        Missing& missing = missing_[{target, known.empty() ? "" : name}];
        if (known.empty()) {  // the first one stands for all
            if (!missing.places.empty() && missing.places.front() < place) return false;
            missing.places.clear();
        }
        missing.message = "there is no " + what + " '" + name + "'";
        missing.hint = known.empty() ? "; the case defines none" : didYouMean(name, known);
        missing.places.push_back(place);
        return false;
    }

    void checkTraits(const Reference& reference, const std::string& body) {
        const auto traits = traits_.find(body);
        if (reference.traits.empty() || traits == traits_.end() ||
            intersects(traits->second, reference.traits))
            return;
        Words fitting;
        for (const auto& [name, words] : traits_)
            if (intersects(words, reference.traits)) fitting.push_back(name);
        report(reference.name.place,
               reference.label + " is '" + body + "', which is " + joined(traits->second) +
                   ", but must be " + alternatives(reference.traits) +
                   (fitting.empty() ? "" : "; such bodies: " + joined(fitting)));
    }

    void checkPart(const Reference& reference) {
        const auto [body_name, part] = model::splitAction(reference.name.text);
        if (!exists(reference, Target::body, body_name, "body")) return;
        checkTraits(reference, body_name);
        if (part.empty()) return;
        Words parts;
        for (const NamedBody& body : block_.bodies)
            if (body.name == body_name)
                for (const auto& [name, shape] : body.block.parts) parts.push_back(name.text);
        if (std::find(parts.begin(), parts.end(), part) == parts.end())
            report(reference.name.place,
                   "the body '" + body_name + "' has no part '" + part + "'" +
                       (parts.empty() ? "; it defines none" : didYouMean(part, parts)));
    }

    void checkMaterial(const Reference& reference) {
        const Component* material = findComponent(block_.materials, reference.name.text);
        if (reference.traits.empty() || !material->declaration ||
            intersects(material->declaration->traits(), reference.traits))
            return;
        report(reference.name.place, reference.label + " is '" + reference.name.text + "', " +
                                         withArticle(material->declaration->name()) +
                                         ", but must be " + alternatives(reference.traits));
    }

    void checkMethod(const Reference& reference) {
        const bool time_step = !reference.traits.empty();
        const Component* method = findComponent(block_.dynamics, reference.name.text);
        if (!time_step || !method->declaration || method->declaration->isTimeStep()) return;
        Words fitting;
        for (const Component& one : block_.dynamics)
            if (one.declaration && one.declaration->isTimeStep()) fitting.push_back(one.name);
        report(reference.name.place,
               reference.label + " is '" + reference.name.text + "', " +
                   withArticle(method->declaration->name()) + ", but must be a time-step method" +
                   (fitting.empty() ? "; the case defines none" : ": " + alternatives(fitting)));
    }

    void checkAction(const Reference& reference) {
        const auto [name, action] = model::splitAction(reference.name.text);
        if (!exists(reference, Target::method, name, "method")) return;
        const Component* method = findComponent(block_.dynamics, name);
        if (!method->declaration) return;
        const Place& place = reference.name.place;
        if (method->declaration->isTimeStep()) {
            report(place,
                   "'" + name + "' is a time-step method: it belongs to the 'dt' of a layer");
            return;
        }
        Words actions;
        for (const Action& one : method->declaration->actions())
            if (!one.name().empty()) actions.push_back(one.name());
        if (method->declaration->actionIndex(action) >= 0) return;
        if (action.empty())
            report(place, "'" + name + "' has several actions; write " + name + "." +
                              alternatives(actions));
        else
            report(place, "'" + name + "' has no action '" + action + "'" +
                              (actions.empty() ? "; write '" + name + "' alone"
                                               : didYouMean(action, actions)));
    }

    const CaseBlock& block_;
    Reader& reader_;
    std::map<Target, Words> known_;
    std::set<Target> spoilt_;
    std::map<std::pair<Target, std::string>, Missing> missing_;
    std::map<std::string, Words> traits_;
};

}  // namespace

const Component* findComponent(const std::vector<Component>& components, std::string_view name) {
    for (const Component& component : components)
        if (component.name == name) return &component;
    return nullptr;
}

bodies::Role roleOf(BodyKind kind, const Component* material) {
    switch (kind) {
        case BodyKind::fluid: return bodies::Role::fluid;
        case BodyKind::observer: return bodies::Role::observer;
        case BodyKind::solid: break;
    }
    const bool elastic =
        material && material->declaration && material->declaration->hasTrait("elastic");
    return elastic ? bodies::Role::elastic : bodies::Role::wall;
}

std::vector<std::string> bodyTraits(bodies::Role role, const Component* material) {
    Words traits{role == bodies::Role::fluid      ? "fluid"
                 : role == bodies::Role::observer ? "observer"
                                                  : "solid"};
    if (!material || !material->declaration) return traits;
    for (const std::string& trait : material->declaration->traits())
        if (std::find(traits.begin(), traits.end(), trait) == traits.end()) traits.push_back(trait);
    if (std::find(traits.begin(), traits.end(), material->declaration->name()) == traits.end())
        traits.push_back(material->declaration->name());
    return traits;
}

void checkNames(const CaseBlock& block, const Node& root, Reader& reader) {
    NameCheck check(block, root, reader);
    for (const Reference& reference : reader.references) check.check(reference);
    check.reportMissing();
}

}  // namespace sphinx::language
