// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "input/declaration/declaration.h"

#include <algorithm>

namespace sphinx::input {

const char* kindName(Kind kind) {
    switch (kind) {
        case Kind::block: return "block";
        case Kind::shape: return "shape";
        case Kind::kernel: return "kernel";
        case Kind::material: return "material";
        case Kind::dynamics: return "dynamics";
        case Kind::joint: return "joint";
        case Kind::multibody_force: return "multibody_force";
        case Kind::multibody_constraint: return "multibody_constraint";
        case Kind::output: return "output";
        case Kind::field: return "field";
    }
    return "";
}

Action& Action::add(AccessMode mode, const std::string& owner, Fields fields, bool if_made,
                    bool result) {
    for (std::string_view field : fields)
        accesses_.push_back({mode, owner, std::string(field), if_made, result});
    return *this;
}

Action& Action::throughout(std::string why) {
    throughout_ = std::move(why);
    return *this;
}

bool Declaration::hasTrait(std::string_view trait) const {
    return std::find(traits_.begin(), traits_.end(), trait) != traits_.end();
}

const Parameter* Declaration::parameter(std::string_view name) const {
    for (const Parameter& p : parameters_)
        if (p.name == name) return &p;
    return nullptr;
}

int Declaration::actionIndex(std::string_view name) const {
    for (std::size_t k = 0; k < actions_.size(); ++k)
        if (actions_[k].name() == name) return static_cast<int>(k);
    return -1;
}

void Declaration::cite(std::string_view key, std::string where) {
    const Publication* publication = findPublication(key);
    assert(publication && "a publication that sources.cpp does not list");
    citations_.push_back({publication, std::move(where)});
}

void Declaration::add(Parameter added) {
    assert(!parameter(added.name) && "parameter declared twice");
    parameters_.push_back(std::move(added));
}

}  // namespace sphinx::input
