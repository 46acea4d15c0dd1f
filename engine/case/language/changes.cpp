// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/changes.h"

#include "case/language/phases.h"
#include "dynamics/constraint/prescribed_motion.h"

#include <fmt/format.h>
#include <algorithm>

namespace sphinx::model {
namespace {

/// The outputs of frames, where the loop sorts particles.
std::vector<Place> framesOfSorted(const Case& model) {
    const auto sorts = [&](const Component& method) {
        return method.declaration->name() == "particles.sort" && model.calls(method.name);
    };
    std::vector<Place> places;
    if (!std::any_of(model.dynamics.begin(), model.dynamics.end(), sorts)) return places;
    for (const Output& output : model.outputs) {
        const std::string& type = output.declaration->name();
        if (type == "vtu" || type == "vtkhdf" || type == "hdf5" || type == "tecplot")
            places.push_back(output.place);
    }
    return places;
}

/// Motions that turn or shear a rigid body.
std::vector<Place> turnsOfWalls(const Case& model) {
    std::vector<Place> places;
    for (const Component& method : model.dynamics) {
        if (method.declaration->name() != "constraint.prescribed_motion" ||
            !model.calls(method.name))
            continue;
        const auto& p = method.as<constraint::PrescribedMotionParameters>();
        const Body* body = model.findBody(splitAction(p.part.text).first);
        const bool turns = std::ranges::any_of(
            p.displacement, [](const input::FieldExpression& u) { return u.dependsOnPlace(); });
        if (turns && body->role == Role::wall) places.push_back(method.placeOf("displacement"));
    }
    return places;
}

}  // namespace

std::span<const LanguageChange> languageChanges() {
    static const std::vector<LanguageChange> changes{
        {2, false, framesOfSorted,
         "frames hold the particles in the order of their ids, not in that of the memory, which "
         "particles.sort changes"},
        {2, true, turnsOfWalls, "the normals of a rigid body turn with its prescribed motion"},
    };
    return changes;
}

void warnChanges(const Case& model, int version, std::span<const LanguageChange> changes,
                 input::Diagnostics& diagnostics) {
    for (const LanguageChange& change : changes) {
        if (change.version <= version) continue;
        for (const Place& place : change.concerns(model))
            diagnostics.warning(
                place, fmt::format("since version {} of the language {}; 'sphinx: {}' in the case "
                                   "says that it means this",
                                   change.version, change.text, language_version));
    }
}

int stateVersion(const Case& model, std::span<const LanguageChange> changes) {
    int version = 1;
    for (const LanguageChange& change : changes)
        if (change.of_state && !change.concerns(model).empty())
            version = std::max(version, change.version);
    return version;
}

}  // namespace sphinx::model
