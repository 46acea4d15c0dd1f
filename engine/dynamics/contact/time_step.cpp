// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "dynamics/contact/force.h"
#include "dynamics/methods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace sphinx::dynamics::contact {
namespace {

struct TimeStepParameters {
    input::Name body;
    std::optional<double> cfl;
};

/// Of an elastic body the own step is shorter than that of its contact by default. A rigid body
/// rebounds within it, and gains 1e-4 of its energy at most with 0.05, 3e-3 with 0.3: README.md.
constexpr double cfl_of_elastic = 0.4;
/// Of the stiffness: a step before surfaces touch may be half as long again.
constexpr double before_touch = 0.44;
constexpr double cfl_of_rigid = 0.05;

/// cfl 2/omega of what contact does to the body at most. A particle of an elastic body has
/// omega^2 = 2 kappa/(rho0 dp), where the other body moves as fast the other way; a rigid body that
/// a mechanism carries omega^2 = 4 kappa A/m, A the area that has another surface in reach: 1 for
/// its way, 3 for its turn, of a thin rod that meets the other surface at its end. A is that of a
/// point at least, and a rigid body moves by a quarter of a spacing at most: so it comes near
/// before it touches.
template <int Dim>
class TimeStep final : public TimeStepMethod {
 public:
    TimeStep(Context<Dim>& context, const TimeStepParameters& p)
        : context_(&context),
          body_(&bodyOf(context, p.body)),
          velocity_(body_->particles.vector(fields::velocity)),
          cfl_(p.cfl.value_or(body_->isElastic() ? cfl_of_elastic : cfl_of_rigid)) {}
    double estimate() override;
    std::size_t workSize() const override { return body_->size(); }

 private:
    Context<Dim>* context_;
    Body<Dim>* body_;
    Field<Vec<Dim>>& velocity_;
    double cfl_;
};

template <int Dim>
double TimeStep<Dim>::estimate() {
    double squared = 0;  // of a frequency
    double rate = 0;     // by viscous friction
    for (PairOwner<Dim>* owner : context_->contacts) {
        for (const auto& pair : owner->pairs()) {
            if (!pair->involves(*body_)) continue;
            if (body_->isElastic()) {
                const double layer = body_->elastic().material->density() * body_->spacing;
                const double stiffening = std::max(pair->stiffening(), before_touch);
                squared += 2 * pair->law().stiffness * stiffening / layer;
                rate += 2 * pair->law().viscous / (layer * body_->spacing);
                continue;
            }
            owner->takePlaces(0);
            pair->search();
            const double point = std::pow(body_->spacing, Dim - 1);
            const double by_mass = std::max(pair->nearArea(*body_), point) / body_->carriedMass();
            squared += 4 * pair->law().stiffness * by_mass;
            rate += 4 * pair->law().viscous / body_->spacing * by_mass;
        }
    }
    double step = std::numeric_limits<double>::infinity();
    if (squared > 0) step = cfl_ * 2 / std::sqrt(squared);
    if (rate > 0) step = std::min(step, cfl_ / rate);
    if (body_->isElastic()) return step;
    const double squared_speed =
        maxAll(body_->size(), 0, [&](std::size_t i) { return velocity_[i].squaredNorm(); });
    if (squared_speed > 0) step = std::min(step, 0.25 * body_->spacing / std::sqrt(squared_speed));
    return step;
}

}  // namespace

void declareTimeStep(input::Registry& registry) {
    using P = TimeStepParameters;
    auto& d = registry.declare<P>(input::Kind::dynamics, "contact.time_step")
                  .builder(factory<TimeStepMethod, P>(Construct<TimeStep, P>{}));
    d.summary("Time step of a solid by the stiffness of its contacts");
    d.formula(
        "cfl 2/omega; omega^2 = 2 kappa/(rho0 dp) of an elastic body, 4 kappa A/m of a rigid one "
        "with the area A near to others, which also moves by dp/4 at most");
    d.required("body", &P::body, input::bodyReference({"elastic", "rigid"}),
               "elastic body, or rigid body that a mechanism carries");
    d.optional(
        "cfl", &P::cfl, input::number(unit::none).above(0).atMost(1),
        "factor; without: 0.6 for an elastic body, 0.05 for a rigid one, which then gains no "
        "more than 1e-4 of its energy in a rebound");
    d.timeStep("").reads("body", {"position", "velocity"});
}

}  // namespace sphinx::dynamics::contact
