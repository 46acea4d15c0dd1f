// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/solid/stress_update.h"

#include "dynamics/solid/hourglass_rule.h"

namespace sphinx::dynamics::solid {

void declareStressUpdate(input::Registry& registry) {
    using P = StressUpdateParameters;
    auto& d = declareMethod<P>(registry, "solid.stress_update",
                               []<int Dim>(const P& p, Context<Dim>& context) {
                                   return std::make_unique<StressUpdate<Dim>>(
                                       context, bodyOf(context, p.body), p.hourglass_control);
                               });
    d.summary("Stress of an elastic body whose particles are held, for bodies bonded to it");
    d.formula(
        "guide (29), (6): F += dt/2 dF/dt and P(F) in the first half; dF/dt and F += dt/2 "
        "dF/dt in the second");
    d.cite("guide", "(29), (6)");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body that is held");
    d.optional("hourglass_control", &P::hourglass_control, input::boolean(),
               "as in solid.stress_relaxation of the bodies bonded to it");
    d.trait("sums_over_itself");
    d.rule(checkHourglassControl);
    d.action("first_half", "deformation and stress to the half step",
             [](auto& method, const Clock& clock) { method.firstHalf(clock); })
        .reads("body", {"initial_position", "velocity", "volume", "correction_matrix",
                        "deformation_gradient", "deformation_rate"})
        .reads("bonded", {"initial_position", "volume"})
        .writes("body", {"deformation_gradient", "corrected_stress", "density"})
        .opens("body", "step");
    d.action("second_half", "rate of the deformation; deformation to the full step",
             [](auto& method, const Clock& clock) { method.secondHalf(clock); })
        .reads("body", {"velocity", "correction_matrix", "deformation_gradient"})
        .reads("bonded", {"velocity"})
        .writes("body", {"deformation_rate", "deformation_gradient"})
        .closes("body", "step");
}

}  // namespace sphinx::dynamics::solid
