// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// The compiler may fuse products and sums here, and the bits depend on it: engine/CMakeLists.txt.
#ifndef SPHINX_FUSED
#error "compile this file with -ffp-contract=fast and SPHINX_FUSED"
#endif

#include "dynamics/solid/stress_relaxation.h"

#include "core/parallel.h"
#include "dynamics/solid/hourglass_rule.h"

#include <fmt/format.h>

namespace sphinx::dynamics::solid {

template <int Dim>
StressRelaxation<Dim>::StressRelaxation(Context<Dim>& context, Body<Dim>& body,
                                        bool hourglass_control, bool damping)
    : body_(&body),
      deformation_(context, body, hourglass_control),
      damping_(damping),
      position_(body.particles.position()),
      velocity_(body.particles.vector(fields::velocity)),
      acceleration_(body.particles.vector(fields::acceleration)),
      external_(body.particles.vector(fields::external_acceleration)),
      pressure_force_(body.particles.vector(fields::pressure_force)),
      viscous_force_(body.particles.vector(fields::viscous_force)),
      mass_(body.particles.scalar(fields::mass)),
      volume_(body.particles.scalar(fields::volume)) {}

template <int Dim>
void StressRelaxation<Dim>::firstHalf(const Clock& clock) {
    const double dt = clock.dt;
    parallelFor(body_->size(), [&](std::size_t i) { position_[i] += 0.5 * dt * velocity_[i]; });
    deformation_.firstHalf(clock, damping_);
    parallelForGroups(body_->size(), [&](const Group& group) {
        using Vector = VecOf<Dim, Wide>;
        const Vector force = load(volume_, group) * deformation_.stressDivergence(group) +
                             load(pressure_force_, group) + load(viscous_force_, group);
        const Vector a = force / load(mass_, group) + load(external_, group);
        store(a, acceleration_, group);
        const Vector v = load(velocity_, group) + dt * a;
        store(v, velocity_, group);
    });
    ++body_->version;
}

template <int Dim>
void StressRelaxation<Dim>::secondHalf(const Clock& clock) {
    const double dt = clock.dt;
    deformation_.secondHalf(dt);
    parallelFor(body_->size(), [&](std::size_t i) { position_[i] += 0.5 * dt * velocity_[i]; });
    ++body_->version;
}

namespace {

/// Of two bodies that are bonded one moves, the other hands its stress on.
void checkBonded(const input::Component& method, WrittenCase& written) {
    const input::Name& body = method.as<StressRelaxationParameters>().body;
    for (const input::Component* other : written.methods) {
        if (other == &method) break;
        const auto* p = other->find<StressRelaxationParameters>();
        if (p && written.bonded(body.text, p->body.text))
            written.diagnostics.error(
                body.place,
                fmt::format("{} and {} are bonded and both move: make them one body, or move one "
                            "of them and keep the stress of the other by solid.stress_update",
                            p->body.text, body.text));
    }
}

}  // namespace

void declareStressRelaxation(input::Registry& registry) {
    using P = StressRelaxationParameters;
    auto& d = declareMethod<P>(
        registry, "solid.stress_relaxation", []<int Dim>(const P& p, Context<Dim>& context) {
            return std::make_unique<StressRelaxation<Dim>>(context, bodyOf(context, p.body),
                                                           p.hourglass_control, p.damping);
        });
    d.summary("Step of an elastic body in two halves around the sum of its stresses");
    d.formula(
        "guide (5), (29), (31) as drift-kick-drift; m_i dv_i/dt = sum_j (P_i B_i^T + P_j B_j^T) "
        "e_ij W' V_i V_j, dF_i/dt = -sum_j v_ij (x) e_ij W' V_j B_i");
    d.cite("guide", "(5), (29), (31)")
        .cite("Vignjevic, Reveles & Campbell 2006")
        .cite("Bonet & Lok 1999", "(conjugate form)");
    d.required("body", &P::body, input::bodyReference({"elastic"}), "elastic body that is stepped");
    d.optional("hourglass_control", &P::hourglass_control, input::boolean(),
               "whether neighbors are also held by what the deformation gradient does not see of "
               "their motion; in all bonded bodies alike");
    d.optional(
        "damping", &P::damping, input::boolean(),
        "whether the Kelvin-Voigt damping of the material acts; two methods, one with and one "
        "without, can share the time of a run");
    d.trait("sums_over_itself");
    d.rule(checkBonded);
    d.rule([](const input::Component& method, WrittenCase& written) {
        warnUnbounded(method, written, "solid.acoustic_time_step");
    });
    d.rule(checkHourglassControl);
    d.action("first_half",
             "deformation, stress and position to the half step; velocity by a whole "
             "step",
             [](auto& method, const Clock& clock) { method.firstHalf(clock); })
        .reads("body", {"initial_position", "position", "velocity", "mass", "volume",
                        "correction_matrix", "deformation_gradient", "deformation_rate",
                        "external_acceleration", "pressure_force", "viscous_force"})
        .reads("bonded", {"initial_position", "position", "volume", "corrected_stress"})
        .writes("body", {"deformation_gradient", "corrected_stress", "density", "position",
                         "velocity", "acceleration"})
        .opens("body", "step");
    d.action("second_half", "rate of the deformation; deformation and position to the full step",
             [](auto& method, const Clock& clock) { method.secondHalf(clock); })
        .reads("body", {"position", "velocity", "correction_matrix", "deformation_gradient"})
        .reads("bonded", {"velocity"})
        .writes("body", {"deformation_rate", "deformation_gradient", "position"})
        .closes("body", "step");
}

template class StressRelaxation<2>;
template class StressRelaxation<3>;

}  // namespace sphinx::dynamics::solid
