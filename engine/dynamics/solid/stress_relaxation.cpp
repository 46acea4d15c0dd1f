// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0

// The compiler may fuse products and sums here, and the bits depend on it: engine/CMakeLists.txt.
#ifndef SPHINX_FUSED
#error "compile this file with -ffp-contract=fast and SPHINX_FUSED"
#endif

#include "core/parallel.h"
#include "dynamics/methods.h"
#include "dynamics/outer_forces.h"
#include "dynamics/radiation.h"
#include "dynamics/solid/deformation.h"
#include "dynamics/solid/hourglass_rule.h"

#include <fmt/format.h>

namespace sphinx::dynamics::solid {
namespace {

/// Elastic step of a total-Lagrangian solid, guide (5), as drift-kick-drift:
///   first half:  F += dt/2 dF, r += dt/2 v, P(F), then
///                dv_i = V_i/m_i sum_j (P_i B_i^T + P_j B_j^T) e_ij W' V_j + external,  v += dt dv
///                (with the hourglass control and the shares of particles, see Deformation)
///   second half: dF_i = -sum_j v_ij (x) e_ij W' V_j B_i,  F += dt/2 dF, r += dt/2 v
/// all sums in the reference configuration. External are the accumulated accelerations and the
/// forces of fluids by pressure and viscosity, to which the fluids' answer to the motion within
/// their step comes (Radiation). A constraint acts between the halves.
template <int Dim>
class StressRelaxation final : public Method {
 public:
    StressRelaxation(Context<Dim>& context, const StressRelaxationParameters& p);
    void announce() override { deformation_.announce(); }
    void prepare() override {
        deformation_.prepare();
        outer_.prepare(body_->particles);
    }
    std::size_t workSize() const override { return body_->size(); }

    void firstHalf(const Clock& clock);
    void secondHalf(const Clock& clock);

 private:
    /// Positions by half a step.
    void drift(double dt);

    Body<Dim>* body_;
    Deformation<Dim> deformation_;
    bool damping_;
    Field<Vec<Dim>>& position_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& acceleration_;
    OuterForces<Dim> outer_;
    Radiation<Dim> radiation_;
    Field<double>& mass_;
    Field<double>& volume_;
};

template <int Dim>
StressRelaxation<Dim>::StressRelaxation(Context<Dim>& context, const StressRelaxationParameters& p)
    : body_(&bodyOf(context, p.body)),
      deformation_(context, *body_, p.hourglass_control),
      damping_(p.damping),
      position_(body_->particles.position()),
      velocity_(body_->particles.vector(fields::velocity)),
      acceleration_(body_->particles.vector(fields::acceleration)),
      outer_(body_->particles),
      radiation_(body_->particles),
      mass_(body_->particles.scalar(fields::mass)),
      volume_(body_->particles.scalar(fields::volume)) {}

template <int Dim>
void StressRelaxation<Dim>::drift(double dt) {
    parallelForGroups(body_->size(), [&](const Group& group) {
        addProduct(0.5 * dt, velocity_, position_, group);
    });
    ++body_->version;
}

template <int Dim>
void StressRelaxation<Dim>::firstHalf(const Clock& clock) {
    const double dt = clock.dt;
    drift(dt);
    deformation_.firstHalf(clock, damping_);
    radiation_.begin(dt);
    parallelForGroups(body_->size(), [&](const Group& group) {
        using Vector = VecOf<Dim, Wide>;
        Vector force = load(volume_, group) * deformation_.stressDivergence(group) +
                       load(outer_.pressure, group) + load(outer_.viscous, group);
        if (outer_.contact) force += load(*outer_.contact, group);
        const Wide by_mass = 1 / load(mass_, group);
        Vector a = by_mass * force + load(outer_.external, group);
        Vector v = load(velocity_, group) + dt * a;
        if (radiation_.acts()) {
            const Vector answer = radiation_.answer(group, v);
            a += answer;
            v += dt * answer;
        }
        store(a, acceleration_, group);
        store(v, velocity_, group);
    });
}

template <int Dim>
void StressRelaxation<Dim>::secondHalf(const Clock& clock) {
    const double dt = clock.dt;
    radiation_.begin(dt);
    radiation_.addSlip();
    deformation_.secondHalf(dt);
    drift(dt);
}

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
    auto& d = declareMethod<StressRelaxation, P>(registry, "solid.stress_relaxation");
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
        .mayRead("body", {"radiation_impedance", "average_velocity", "contact_force"})
        .writes("body", {"deformation_gradient", "corrected_stress", "density", "position",
                         "velocity", "acceleration"})
        .opens("body", "step");
    d.action("second_half", "rate of the deformation; deformation and position to the full step",
             [](auto& method, const Clock& clock) { method.secondHalf(clock); })
        .reads("body", {"position", "velocity", "correction_matrix", "deformation_gradient"})
        .reads("bonded", {"velocity"})
        .mayRead("body", {"radiation_impedance", "average_velocity", "slip"})
        .mayWrite("body", {"slip"})
        .writes("body", {"deformation_rate", "deformation_gradient", "position"})
        .closes("body", "step");
}

}  // namespace sphinx::dynamics::solid
