// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/methods.h"
#include "dynamics/solid/deformation.h"
#include "dynamics/solid/hourglass_rule.h"

namespace sphinx::dynamics::solid {
namespace {

/// Deformation and stress of an elastic body whose particles are held, in two halves around the
/// step of a body that is bonded to it: guide, chapter 5, the base of the gate. Nothing moves.
template <int Dim>
class StressUpdate final : public Method {
 public:
    StressUpdate(Context<Dim>& context, const StressUpdateParameters& p)
        : deformation_(context, bodyOf(context, p.body), p.hourglass_control) {}
    void announce() override { deformation_.announce(); }
    void prepare() override { deformation_.prepare(); }
    void firstHalf(const Clock& clock) { deformation_.firstHalf(clock); }
    void secondHalf(const Clock& clock) { deformation_.secondHalf(clock.dt); }
    std::size_t workSize() const override { return deformation_.body().size(); }

 private:
    Deformation<Dim> deformation_;
};

}  // namespace

void declareStressUpdate(input::Registry& registry) {
    using P = StressUpdateParameters;
    auto& d = declareMethod<StressUpdate, P>(registry, "solid.stress_update");
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
