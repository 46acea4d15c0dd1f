// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/density_summation.h"

#include "dynamics/fluid/support.h"
#include "dynamics/methods.h"
#include "materials/fluid.h"
#include "neighbors/pair_tiles.h"

#include <cmath>

namespace sphinx::dynamics::fluid {
namespace {

/// tau c0, in spacings.
constexpr double relaxation_length = 250;

template <int Dim>
class DensitySummation final : public Method {
 public:
    DensitySummation(Context<Dim>& context, const DensitySummationParameters& p);

    void run(const Clock& clock);
    std::size_t workSize() const override { return body_->size(); }

 private:
    void runFree(double dt);
    void freeDensity(const Group& group, double correction);

    Body<Dim>* body_;
    double rho0_;
    double cell_;  // volume of a particle of the lattice
    double tau_;
    Support<Dim> support_;
    Field<double>& mass_;
    Field<double>& density_;
    Field<double>& slack_;
    Field<double>* reference_ = nullptr;  // confined
};

template <int Dim>
DensitySummation<Dim>::DensitySummation(Context<Dim>& context, const DensitySummationParameters& p)
    : body_(&bodyOf(context, p.body)),
      rho0_(body_->fluid().material->density()),
      cell_(std::pow(body_->spacing, Dim)),
      tau_(relaxation_length * body_->spacing / body_->fluid().material->soundSpeed()),
      support_(context, *body_),
      mass_(body_->particles.scalar(fields::mass)),
      density_(body_->particles.scalar(fields::density)),
      slack_(body_->particles.scalar(fields::slack)) {
    if (p.surface == Surface::confined)
        reference_ = &body_->particles.scalar(fields::reference_density);
}

template <int Dim>
void DensitySummation<Dim>::run(const Clock& clock) {
    if (!reference_) return runFree(clock.is_start ? 0 : clock.dt);
    parallelForGroups(body_->size(), [&](const Group& group) {
        store(load(*reference_, group) * support_.share(group), density_, group);
    });
}

template <int Dim>
void DensitySummation<Dim>::runFree(double dt) {
    const double correction = -std::expm1(-dt / tau_);
    support_.findSurface(body_->size());
    parallelForGroups(body_->size(), [&](const Group& group) { freeDensity(group, correction); });
}

template <int Dim>
[[gnu::always_inline]] inline void DensitySummation<Dim>::freeDensity(const Group& group,
                                                                      double correction) {
    const Wide rho0 = rho0_;
    const Wide rho = load(density_, group);
    const Wide share = support_.share(group);
    const LaneMask was_slack = load(slack_, group) > 0;
    const LaneMask at_solid = support_.seesSolid(group);
    const LaneMask lacks = support_.isLacking(share);
    store(select(at_solid | lacks, Wide(1), Wide(0)), slack_, group);
    const Wide sum = load(mass_, group) / cell_ * share;
    // At a solid a sum below rho0 tells a gap, not tension.
    const Wide right =
        select(at_solid & (sum < rho0), select(rho < sum, sum, select(rho > rho0, rho0, rho)), sum);
    Wide value = rho + correction * (right - rho);
    // Up to rho0 there is no pressure yet: what is said of a gap costs no work.
    const Wide upwards = max(select(sum < rho0, sum, rho0), rho + correction * (sum - rho));
    value = select(support_.isCutOff(group), max(rho, upwards), value);
    value = select(~at_solid & (was_slack | lacks), max(rho, rho0), value);
    store(select(support_.isAlone(group), rho0, value), density_, group);
}

}  // namespace

void declareDensitySummation(input::Registry& registry) {
    using P = DensitySummationParameters;
    auto& d = declareMethod<DensitySummation, P>(registry, "fluid.density_summation");
    d.summary("Density from the sum of the kernel over the neighbors");
    d.formula(
        "free: rho += (1 - exp(-dt/tau)) (m/V0 S/S0 - rho), tau = 250 spacing/c0, where no surface "
        "cuts off a part of S, else upwards only, guide (54), up to rho0 at once and above it with "
        "the same tau, and no tension without "
        "support or at solids; (55) confined: rho(start) S/S0");
    d.cite("guide", "(54), (55)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("surface", &P::surface, surfaceWords(), "whether the fluid has a free surface");
    d.trait("sums_over_itself");
    d.action()
        .reads("body", {"density", "reference_density", "mass", "slack", "fresh_neighbors"})
        .writes("body", {"density", "slack"});
}

}  // namespace sphinx::dynamics::fluid
