// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/linear_correction.h"

namespace sphinx::dynamics::solid {

void declareLinearCorrection(input::Registry& registry) {
    using P = LinearCorrectionParameters;
    auto& d = declareMethod<P>(
        registry, "solid.linear_correction", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<LinearCorrection<Dim>>(context, bodyOf(context, p.body));
        });
    d.summary(
        "Correction matrices and initial deformation of an elastic body; belongs to the start");
    d.formula("guide (30): B_i = (-sum_j R_ij (x) e_ij W' V_j)^-1 in the reference configuration");
    d.cite("guide", "(30)").cite("Randles & Libersky 1996");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body");
    d.trait("sums_over_itself");
    d.action()
        .reads("body", {"initial_position", "position", "velocity", "volume"})
        .reads("bonded", {"initial_position", "position", "velocity", "volume"})
        .writes("body", {"correction_matrix", "deformation_gradient", "deformation_rate"});
}

}  // namespace sphinx::dynamics::solid
