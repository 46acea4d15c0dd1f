// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/density_summation.h"

#include "core/aligned.h"
#include "core/parallel.h"
#include "dynamics/methods.h"
#include "materials/fluid.h"
#include "neighbors/pair_tiles.h"

#include <algorithm>
#include <atomic>
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
    /// What the neighbors in one solid add to S_i, each of them.
    struct Term {
        const Relation<Dim>* relation;
        double weight;
    };

    void runFree(double dt);
    double freeDensity(std::size_t i, double correction, bool inside);
    double share(std::size_t i) const;
    bool seesSolid(std::size_t i) const;
    void findInside();

    Body<Dim>* body_;
    double rho0_;
    double own_;          // W(0)
    double lattice_sum_;  // S0
    double least_share_;  // of S0 that a particle with support has
    double cell_;         // volume of a particle of the lattice
    double tau_;
    const PairTiles<Dim>* self_;
    std::vector<Term> terms_;
    Field<double>& mass_;
    Field<double>& density_;
    Field<double>& slack_;
    Field<double>* reference_ = nullptr;  // confined
    // Filled anew in every call.
    AlignedVector<double> share_;          // S/S0
    AlignedVector<std::uint8_t> lacks_;    // support, of the slots of self_
    AlignedVector<std::uint8_t> cut_off_;  // a neighbor lacks support, likewise
};

template <int Dim>
DensitySummation<Dim>::DensitySummation(Context<Dim>& context, const DensitySummationParameters& p)
    : body_(&bodyOf(context, p.body)),
      rho0_(body_->fluid().material->density()),
      own_(body_->kernel.value(0)),
      lattice_sum_(body_->kernel.latticeSum()),
      least_share_(0.5 + 0.5 * body_->kernel.surfaceSum() / lattice_sum_),
      cell_(std::pow(body_->spacing, Dim)),
      tau_(relaxation_length * body_->spacing / body_->fluid().material->soundSpeed()),
      self_(&context.relations.ownPairs(*body_)),
      mass_(body_->particles.scalar(fields::mass)),
      density_(body_->particles.scalar(fields::density)),
      slack_(body_->particles.scalar(fields::slack)) {
    Body<Dim>& body = *body_;
    if (p.surface == Surface::confined)
        reference_ = &body.particles.scalar(fields::reference_density);
    for (Body<Dim>* other : body.sees)
        if (other != &body)
            terms_.push_back({&context.relations.flow(body, *other, {.kernel_sum = true}),
                              std::pow(other->spacing / body.spacing, Dim)});
}

template <int Dim>
void DensitySummation<Dim>::run(const Clock& clock) {
    if (!reference_) return runFree(clock.is_start ? 0 : clock.dt);
    parallelFor(body_->size(), [&](std::size_t i) { density_[i] = (*reference_)[i] * share(i); });
}

template <int Dim>
void DensitySummation<Dim>::runFree(double dt) {
    const double correction = -std::expm1(-dt / tau_);
    share_.resize(body_->held());
    parallelFor(body_->size(), [&](std::size_t i) { share_[i] = share(i); });
    findInside();
    parallelFor(self_->firstCopy(), [&](std::size_t s) {
        const Index i = self_->particle(static_cast<Index>(s));
        if (i != PairTiles<Dim>::none)
            density_[i] = freeDensity(i, correction, lacks_[s] == 0 && cut_off_[s] == 0);
    });
}

/// Inside: no surface cuts off a part of its own neighborhood.
template <int Dim>
double DensitySummation<Dim>::freeDensity(std::size_t i, double correction, bool inside) {
    const double rho = density_[i];
    const bool was_slack = slack_[i] > 0;
    const bool at_solid = seesSolid(i);
    const bool supported = share_[i] >= least_share_;
    slack_[i] = at_solid || !supported;
    const bool alone = !at_solid && self_->kernelSum(i) == 0;
    if (alone) return rho0_;
    if (!at_solid && (was_slack || !supported)) return std::max(rho, rho0_);
    const double sum = mass_[i] / cell_ * share_[i];
    if (!inside) return std::max(rho, sum);
    // At a solid a sum below rho0 tells a gap, not tension.
    const double right = at_solid && sum < rho0_ ? std::clamp(rho, sum, rho0_) : sum;
    return rho + correction * (right - rho);
}

/// S_i/S0: how much of its neighborhood the particle has.
template <int Dim>
double DensitySummation<Dim>::share(std::size_t i) const {
    double sum = own_ + self_->kernelSum(i);
    for (const Term& term : terms_) sum += term.weight * term.relation->list.kernel_sum[i];
    return sum / lattice_sum_;
}

template <int Dim>
bool DensitySummation<Dim>::seesSolid(std::size_t i) const {
    return std::any_of(terms_.begin(), terms_.end(),
                       [&](const Term& term) { return term.relation->list.kernel_sum[i] > 0; });
}

/// Particles that lack support tell their neighbors.
template <int Dim>
void DensitySummation<Dim>::findInside() {
    lacks_.resize(self_->slots() + 3);  // anyOf() reads beyond the last
    cut_off_.assign(self_->slots(), 0);
    parallelFor(self_->slots(), [&](std::size_t s) {
        const Index i = self_->particle(static_cast<Index>(s));
        lacks_[s] = i != PairTiles<Dim>::none && share_[i] < least_share_;
    });
    const auto tell = [&](Index slot) {  // several threads may say the same
        std::atomic_ref(cut_off_[slot]).store(1, std::memory_order_relaxed);
    };
    self_->forEachCluster(
        [&](Index first, const std::uint32_t* j, std::size_t count, auto&& pairs) {
            const std::uint8_t* i_lacks = lacks_.data() + first;
            const bool any_i = (i_lacks[0] | i_lacks[1] | i_lacks[2] | i_lacks[3]) != 0;
            if (!any_i && !anyOf(lacks_.data(), j, count)) return;
            for (std::size_t tile = 0; tile_side * tile < count; ++tile, j += tile_side) {
                // Lane 4 i + j is the pair of i and j.
                unsigned of_lacking_i = 0, of_lacking_j = 0;
                for (int k = 0; k < tile_side; ++k) {
                    if (i_lacks[k] != 0) of_lacking_i |= 0xfu << (tile_side * k);
                    if (lacks_[j[k]] != 0) of_lacking_j |= 0x1111u << k;
                }
                if ((of_lacking_i | of_lacking_j) == 0) continue;
                const unsigned all = pairs(tile);
                for (int k = 0; k < tile_side; ++k) {
                    if ((all & of_lacking_i & (0x1111u << k)) != 0) tell(j[k]);
                    if ((all & of_lacking_j & (0xfu << (tile_side * k))) != 0)
                        tell(first + static_cast<Index>(k));
                }
            }
        });
}

}  // namespace

void declareDensitySummation(input::Registry& registry) {
    using P = DensitySummationParameters;
    auto& d = declareMethod<DensitySummation, P>(registry, "fluid.density_summation");
    d.summary("Density from the sum of the kernel over the neighbors");
    d.formula(
        "free: rho += (1 - exp(-dt/tau)) (m/V0 S/S0 - rho), tau = 250 spacing/c0, where no surface "
        "cuts off a part of S, else guide (54): max(rho, m/V0 S/S0), and no tension without "
        "support or at solids; (55) confined: rho(start) S/S0");
    d.cite("guide", "(54), (55)").cite("Zhang, Hu & Adams 2017");
    d.required("body", &P::body, input::bodyReference({"fluid"}), "fluid");
    d.optional("surface", &P::surface,
               input::choice<Surface>({
                   {"free", Surface::free, "flow with a free surface"},
                   {"confined", Surface::confined, "flow without free surface"},
               }),
               "whether the fluid has a free surface");
    d.trait("sums_over_itself");
    d.action()
        .reads("body", {"density", "reference_density", "mass", "slack", "fresh_neighbors"})
        .writes("body", {"density", "slack"});
}

}  // namespace sphinx::dynamics::fluid
