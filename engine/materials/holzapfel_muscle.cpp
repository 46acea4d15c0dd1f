// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "materials/holzapfel_muscle.h"

#include "input/expressions/vector_at_time.h"
#include "materials/stiffness.h"

#include <fmt/format.h>

namespace sphinx::materials {
namespace {

/// dS/dE at rest with the fibre along x and the sheet along y.
Stiffness stiffnessAtRest(const HolzapfelMuscleParameters& p) {
    Stiffness tensor = Stiffness::Zero();
    tensor.topLeftCorner<3, 3>().setConstant(p.lame_lambda);
    tensor.diagonal().head<3>().array() += 2 * p.a;
    tensor.diagonal().tail<3>().setConstant(p.a);
    tensor(0, 0) += 4 * p.a_f;
    tensor(1, 1) += 4 * p.a_s;
    tensor(5, 5) += p.a_fs;
    return tensor;
}

template <int Dim>
std::string text(const Vec<Dim>& v) {
    return Dim == 2 ? fmt::format("[{:g}, {:g}]", v[0], v[1])
                    : fmt::format("[{:g}, {:g}, {:g}]", v[0], v[1], v[Dim - 1]);
}

bool constant(const std::vector<input::FieldExpression>& fields) {
    for (const input::FieldExpression& field : fields)
        if (!field.constant()) return false;
    return true;
}

bool dependsOnTime(const std::vector<input::FieldExpression>& fields) {
    for (const input::FieldExpression& field : fields)
        if (field.dependsOnTime()) return true;
    return false;
}

}  // namespace

template <int Dim>
auto HolzapfelMuscleParameters::directions(const Vec<Dim>& place, Fibres<Dim>& fibres) const
    -> std::optional<Violation> {
    const std::string where = constant(fibre) && constant(sheet) ? "" : " at " + text<Dim>(place);
    const Vec<Dim> along = input::VectorAtTime<Dim>(fibre, 0)(place);
    if (!(along.norm() > 0) || !along.allFinite())
        return Violation{"fibre", "the fibre " + text<Dim>(along) + " has no direction" + where};
    fibres.fibre = along.normalized();
    if (sheet.empty()) {
        if constexpr (Dim == 2) fibres.sheet << -fibres.fibre[1], fibres.fibre[0];
        return {};
    }
    const Vec<Dim> across = input::VectorAtTime<Dim>(sheet, 0)(place);
    if (!(across.norm() > 0) || !across.allFinite())
        return Violation{"sheet", "the sheet " + text<Dim>(across) + " has no direction" + where};
    fibres.sheet = across.normalized();
    const double cosine = fibres.fibre.dot(fibres.sheet);
    if (std::abs(cosine) > 1e-3)
        return Violation{"sheet", fmt::format("the sheet {} must be orthogonal to the fibre {}, "
                                              "but the cosine of their angle is {:.4g}{}",
                                              text<Dim>(across), text<Dim>(along), cosine, where)};
    fibres.sheet = (fibres.sheet - cosine * fibres.fibre).normalized();
    return {};
}

auto HolzapfelMuscleParameters::violation() const -> std::optional<Violation> {
    if (dependsOnTime(fibre)) return Violation{"fibre", "the fibre must not depend on time"};
    if (dependsOnTime(sheet)) return Violation{"sheet", "the sheet must not depend on time"};
    if (fibre.size() == 3 && sheet.empty())
        return Violation{"sheet", "the sheet is missing: in 3D it does not follow from the fibre"};
    if (!constant(fibre) || !constant(sheet)) return {};
    if (fibre.size() == 2) {
        Fibres<2> fibres;
        return directions<2>(Vec<2>::Zero(), fibres);
    }
    Fibres<3> fibres;
    return directions<3>(Vec<3>::Zero(), fibres);
}

template auto HolzapfelMuscleParameters::directions(const Vec<2>&, Fibres<2>&) const
    -> std::optional<Violation>;
template auto HolzapfelMuscleParameters::directions(const Vec<3>&, Fibres<3>&) const
    -> std::optional<Violation>;

HolzapfelMuscle::HolzapfelMuscle(const Parameters& p) : ElasticSolid(p.density, p.damping), p_(p) {
    const Stiffness tensor = stiffnessAtRest(p);
    longitudinal_modulus_ = largestLongitudinalModulus(tensor);
    bulk_modulus_ = averageBulkModulus(tensor);
    shear_modulus_ = averageShearModulus(tensor);
}

}  // namespace sphinx::materials
