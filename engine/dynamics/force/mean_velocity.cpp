// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/sum_all.h"
#include "dynamics/methods.h"
#include "dynamics/part_method.h"
#include "input/expressions/vector_at_time.h"

namespace sphinx::dynamics::force {
namespace {

/// Keeps the mean velocity of a fluid along the periodic axes of the domain, by an acceleration
/// that is the same everywhere. What all else does to the mean is taken to be what it did in the
/// step before, b = (U^n - U^{n-1})/dt^{n-1} - a^{n-1}:
///   a^n = (U*(t + dt) - U^n)/dt - b,
/// so the mean is off by no more than the change of b over a step. In the first step b is 0. Where
/// the flow is steady, M a is minus the force of the solids on the fluid.
struct MeanVelocityParameters {
    input::Name body;
    std::vector<input::FieldExpression> velocity;
};

template <int Dim>
class MeanVelocity final : public PartMethod<AppliedLoad, Dim> {
 public:
    MeanVelocity(Context<Dim>& context, const MeanVelocityParameters& p)
        : PartMethod<AppliedLoad, Dim>(Part<Dim>(context.world, p.body)),
          given_(p.velocity),
          periodic_(context.world.domain.periodic),
          body_(this->part().body()),
          velocity_(body_.particles.vector(fields::velocity)),
          external_(body_.particles.vector(fields::external_acceleration)),
          mass_(body_.particles.scalar(fields::mass)) {}

    void run(const Clock& clock) {
        const double total = this->part().mass();
        const auto mean = [&](const Field<Vec<Dim>>& field) -> Vec<Dim> {
            return sumAll(body_.size(),
                          [&](std::size_t i) -> Vec<Dim> { return mass_[i] * field[i]; }) /
                   total;
        };
        const Vec<Dim> velocity = mean(velocity_);
        const Vec<Dim> wanted =
            input::VectorAtTime<Dim>(given_, clock.time + clock.dt)(Vec<Dim>::Zero());
        Vec<Dim> others = Vec<Dim>::Zero();
        if (last_dt_ > 0) others = (velocity - last_velocity_) / last_dt_ - acceleration_;
        acceleration_ = (wanted - velocity) / clock.dt - others;
        for (int c = 0; c < Dim; ++c)
            if (!periodic_[static_cast<std::size_t>(c)]) acceleration_[c] = 0;
        last_velocity_ = velocity;
        last_dt_ = clock.dt;
        parallelFor(body_.size(), [&](std::size_t i) { external_[i] += acceleration_; });
        Load<Dim> load;
        load.add(mean(body_.particles.position()), total * acceleration_);
        this->setLoad(load);
    }
    void rest() override {
        PartMethod<AppliedLoad, Dim>::rest();
        last_dt_ = 0;
    }
    void transfer(Archive& archive) override {
        PartMethod<AppliedLoad, Dim>::transfer(archive);
        for (auto [name, vector] : {std::pair{"acceleration", &acceleration_},
                                    std::pair{"last_velocity", &last_velocity_}}) {
            std::vector<double> values(vector->begin(), vector->end());
            archive.value(name, values);
            std::copy(values.begin(), values.end(), vector->begin());
        }
        archive.value("last_dt", last_dt_);
    }

 private:
    std::vector<input::FieldExpression> given_;
    std::array<bool, Dim> periodic_;
    Body<Dim>& body_;
    Field<Vec<Dim>>& velocity_;
    Field<Vec<Dim>>& external_;
    Field<double>& mass_;
    Vec<Dim> acceleration_ = Vec<Dim>::Zero();
    Vec<Dim> last_velocity_ = Vec<Dim>::Zero();
    double last_dt_ = 0;  // 0: it has not acted in the step before
};

}  // namespace

void declareMeanVelocity(input::Registry& registry) {
    using P = MeanVelocityParameters;
    auto& d = declareMethod<MeanVelocity, P>(registry, "force.mean_velocity");
    d.summary("Keeps the mean velocity of a fluid along the periodic axes, by a uniform force");
    d.formula(
        "dv_i/dt += a, a^n = (U(t + dt) - U^n)/dt - (U^n - U^{n-1})/dt^{n-1} + a^{n-1}, U^n = "
        "sum_i m_i v_i/sum_i m_i; the force is quantity applied_load of the output reduce");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.required(
        "velocity", &P::velocity, input::fieldVector(unit::velocity),
        "mean velocity, one expression of t for each direction; what stands for an axis that "
        "is not periodic has no effect");
    d.worldRule([](const input::Component& method, auto& built) {
        const auto& periodic = built.world.domain.periodic;
        if (std::none_of(periodic.begin(), periodic.end(), [](bool p) { return p; }))
            built.diagnostics.error(method.placeOf("velocity"),
                                    "no axis of the domain is periodic, and along others walls "
                                    "or a force decide on the mean velocity");
    });
    d.action("once in each step of the outermost layer")
        .reads("body", {"velocity", "mass", "position"})
        .accumulates("body", {"external_acceleration"});
}

}  // namespace sphinx::dynamics::force
