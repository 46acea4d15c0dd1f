// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/methods.h"
#include "dynamics/solid/deformation.h"

namespace sphinx::dynamics::solid {
namespace {

/// Correction matrix B_i of an elastic body, guide (30), and the deformation that its positions and
/// velocities have at the start.
template <int Dim>
class LinearCorrection final : public Method {
 public:
    LinearCorrection(Context<Dim>& context, const BodyParameters& p)
        : deformation_(context, bodyOf(context, p.body), false) {}
    void prepare() override { deformation_.prepare(); }
    void run(const Clock&) { deformation_.initialize(); }
    std::size_t workSize() const override { return deformation_.body().size(); }

 private:
    Deformation<Dim> deformation_;
};

}  // namespace

void declareLinearCorrection(input::Registry& registry) {
    using P = BodyParameters;
    auto& d = declareMethod<LinearCorrection, P>(registry, "solid.linear_correction");
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
