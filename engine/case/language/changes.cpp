// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "case/language/changes.h"

#include "case/language/phases.h"
#include "dynamics/constraint/prescribed_motion.h"
#include "dynamics/fluid/density_summation.h"
#include "dynamics/solid/hourglass_rule.h"

#include <fmt/format.h>
#include <algorithm>
#include <string_view>

namespace sphinx::language {
namespace {

/// The outputs of frames, where the loop sorts particles.
std::vector<input::Place> framesOfSorted(const model::Case& model) {
    const auto sorts = [&](const input::Component& method) {
        return method.declaration->name() == "particles.sort" && model.calls(method.name);
    };
    std::vector<input::Place> places;
    if (!std::any_of(model.dynamics.begin(), model.dynamics.end(), sorts)) return places;
    for (const model::Output& output : model.outputs) {
        const std::string& type = output.declaration->name();
        if (type == "vtu" || type == "vtkhdf" || type == "hdf5" || type == "tecplot")
            places.push_back(output.place);
    }
    return places;
}

/// Motions that turn or shear a rigid body.
std::vector<input::Place> turnsOfWalls(const model::Case& model) {
    std::vector<input::Place> places;
    for (const input::Component& method : model.dynamics) {
        if (method.declaration->name() != "constraint.prescribed_motion" ||
            !model.calls(method.name))
            continue;
        const auto& p = method.as<dynamics::constraint::PrescribedMotionParameters>();
        const model::Body* body = model.findBody(model::splitAction(p.part.text).first);
        const bool turns = std::ranges::any_of(
            p.displacement, [](const input::FieldExpression& u) { return u.dependsOnPlace(); });
        if (turns && body->role == bodies::Role::wall)
            places.push_back(method.placeOf("displacement"));
    }
    return places;
}

/// Methods whose hourglass control acts.
std::vector<input::Place> hourglassControls(const model::Case& model) {
    std::vector<input::Place> places;
    for (const input::Component& method : model.dynamics) {
        const auto* p = method.find<dynamics::solid::StressRelaxationParameters>();
        if (p && p->hourglass_control && model.calls(method.name)) places.push_back(method.place);
    }
    return places;
}

/// Bodies of that role of which no smoothing ratio is stated.
std::vector<input::Place> withoutRatio(const model::Case& model, bodies::Role role) {
    std::vector<input::Place> places;
    if (model.resolution.smoothing_ratio) return places;
    for (const model::Body& body : model.bodies)
        if (body.role == role && !body.resolution.smoothing_ratio) places.push_back(body.place);
    return places;
}
std::vector<input::Place> elasticWithoutRatio(const model::Case& model) {
    return withoutRatio(model, bodies::Role::elastic);
}
std::vector<input::Place> fluidsWithoutRatio(const model::Case& model) {
    return withoutRatio(model, bodies::Role::fluid);
}

/// Whether the case gives the parameter.
bool states(const input::Component& method, std::string_view parameter) {
    return std::ranges::any_of(method.parameter_places,
                               [&](const auto& given) { return given.first == parameter; });
}

/// Time steps of fluids with the quintic spline whose factor is the default.
std::vector<input::Place> stepsOfQuinticSpline(const model::Case& model) {
    std::vector<input::Place> places;
    if (model.resolution.kernel != kernels::KernelType::quintic_spline) return places;
    for (const input::Component& method : model.dynamics) {
        const std::string& type = method.declaration->name();
        if (type != "fluid.acoustic_time_step" && type != "fluid.advection_time_step") continue;
        if (!states(method, "cfl")) places.push_back(method.place);
    }
    return places;
}

/// Acoustic time steps in 2D whose factor is the default.
std::vector<input::Place> acousticStepsIn2D(const model::Case& model) {
    std::vector<input::Place> places;
    if (model.dimension != 2) return places;
    for (const input::Component& method : model.dynamics)
        if (method.declaration->name() == "fluid.acoustic_time_step" && !states(method, "cfl"))
            places.push_back(method.place);
    return places;
}

/// Pressures of fluids on elastic bodies.
std::vector<input::Place> couplings(const model::Case& model) {
    std::vector<input::Place> places;
    for (const input::Component& method : model.dynamics)
        if (method.declaration->name() == "fsi.pressure_force" && model.calls(method.name))
            places.push_back(method.place);
    return places;
}

/// Densities of fluids with a free surface by summation.
std::vector<input::Place> sumsWithFreeSurface(const model::Case& model) {
    std::vector<input::Place> places;
    for (const input::Component& method : model.dynamics) {
        const auto* p = method.find<dynamics::fluid::DensitySummationParameters>();
        if (p && p->surface == dynamics::fluid::Surface::free && model.calls(method.name))
            places.push_back(method.placeOf("surface"));
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
        {2, true, hourglassControls,
         "the hourglass control of elastic bodies has the whole shear modulus as its stiffness, "
         "not a half (2D) or a third (3D) of it"},
        {2, true, elasticWithoutRatio,
         "the default smoothing_ratio of elastic bodies is 0.85, not 1.3"},
        {2, true, fluidsWithoutRatio,
         "the kernel of fluids is quintic_spline with a smoothing_ratio of 1 where neither is "
         "stated, not wendland_c2 with 1.3, and the default ratio of wendland_c2 is 1.5"},
        {2, true, stepsOfQuinticSpline,
         "the default cfl of fluids with quintic_spline is 0.78 (2D: 0.88) and 0.325, not 0.6 and "
         "0.25"},
        {2, true, acousticStepsIn2D,
         "the default cfl of the acoustic step in 2D is larger than in 3D: 0.69, with "
         "quintic_spline 0.88"},
        {2, true, sumsWithFreeSurface,
         "a fluid with a free surface bears no tension at walls and where it has no support, and "
         "inside its density by summation is corrected in both directions, little at a time"},
        {2, true, couplings,
         "a fluid and an elastic body meet along the line of two particles, not along the normal, "
         "and the fluid answers what the body does within its step"},
    };
    return changes;
}

void warnChange(const input::Place& place, int version, const std::string& text,
                input::Diagnostics& diagnostics) {
    diagnostics.warning(place, fmt::format("since version {} of the language {}; 'sphinx: {}' in "
                                           "the case says that it means this",
                                           version, text, language_version));
}

void warnChanges(const model::Case& model, int version, std::span<const LanguageChange> changes,
                 input::Diagnostics& diagnostics) {
    for (const LanguageChange& change : changes) {
        if (change.version <= version) continue;
        for (const input::Place& place : change.concerns(model))
            warnChange(place, change.version, change.text, diagnostics);
    }
}

int stateVersion(const model::Case& model, std::span<const LanguageChange> changes) {
    int version = 1;
    for (const LanguageChange& change : changes)
        if (change.of_state && !change.concerns(model).empty())
            version = std::max(version, change.version);
    return version;
}

}  // namespace sphinx::language
