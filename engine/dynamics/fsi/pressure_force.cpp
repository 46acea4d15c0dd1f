// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fsi/fluid_force.h"
#include "dynamics/methods.h"

namespace sphinx::dynamics::fsi {

void declarePressureForce(input::Registry& registry) {
    auto& d =
        declareFluidForce<fluid::LoadKind::pressure>(registry, "fsi.pressure_force", "pushes");
    d.rule(checkOtherFluids);
    d.summary(
        "Pressure of a fluid on the particles of an elastic body; after the first half of the "
        "fluid's pressure relaxation");
    d.formula(
        "f_j = -sum_i 2 p*_ij e_ji W' V_i V_j, minus what the fluid has felt (guide 2.2.4), and in "
        "the steps of the body -Z_j (v_j - average v_j), Z_j = 2 rho0 c0 sum_i abs(W') e_ij (x) "
        "e_ij V_i V_j, which the fluid feels at the end of its own");
    d.cite("guide", "2.2.4").cite("Zhang, Rezavand & Hu 2021");
    d.action()
        .reads("body", {"volume", "average_velocity", "neighbors"})
        .reads("from", {"pressure", "density", "volume", "external_acceleration"})
        .accumulates("body", {"pressure_force", "radiation_impedance"})
        .within("from", "step");
}

}  // namespace sphinx::dynamics::fsi
