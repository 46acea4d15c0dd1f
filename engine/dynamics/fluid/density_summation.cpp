// SPDX-FileCopyrightText: 2026 The sphinx developers
// SPDX-License-Identifier: Apache-2.0
#include "dynamics/fluid/density_summation.h"

#include "core/aligned.h"
#include "core/parallel.h"
#include "dynamics/group.h"
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
    void freeDensity(const Group& group, double correction, LaneMask outside);
    Wide share(const Group& group) const;
    LaneMask seesSolid(const Group& group) const;
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
    parallelForGroups(body_->size(), [&](const Group& group) {
        store(load(*reference_, group) * share(group), density_, group);
    });
}

template <int Dim>
void DensitySummation<Dim>::runFree(double dt) {
    const double correction = -std::expm1(-dt / tau_);
    findInside();
    parallelForGroups(body_->size(), [&](const Group& group) {
        const Index* slots = self_->slotsOf() + group.first;
        const auto outside = [&](int k) -> std::int64_t {
            return -static_cast<std::int64_t>(lacks_[slots[k]] | cut_off_[slots[k]]);
        };
        freeDensity(group, correction,
                    LaneMask{outside(0), outside(1), outside(2), outside(3), outside(4), outside(5),
                             outside(6), outside(7)});
    });
}

/// `outside`: a surface cuts off a part of its own neighborhood.
template <int Dim>
[[gnu::always_inline]] inline void DensitySummation<Dim>::freeDensity(const Group& group,
                                                                      double correction,
                                                                      LaneMask outside) {
    const Wide rho0 = rho0_;
    const Wide rho = load(density_, group);
    const Wide share = this->share(group);
    const LaneMask was_slack = load(slack_, group) > 0;
    const LaneMask at_solid = seesSolid(group);
    const LaneMask lacks = share < least_share_;
    store(select(at_solid | lacks, Wide(1), Wide(0)), slack_, group);
    const Wide sum = load(mass_, group) / cell_ * share;
    // At a solid a sum below rho0 tells a gap, not tension.
    const Wide right =
        select(at_solid & (sum < rho0), select(rho < sum, sum, select(rho > rho0, rho0, rho)), sum);
    Wide value = rho + correction * (right - rho);
    value = select(outside, max(rho, sum), value);
    value = select(~at_solid & (was_slack | lacks), max(rho, rho0), value);
    const LaneMask alone = ~at_solid & ~(load(self_->kernelSums(), group) > 0);
    store(select(alone, rho0, value), density_, group);
}

/// S_i/S0: how much of its neighborhood the particle has.
template <int Dim>
[[gnu::always_inline]] inline Wide DensitySummation<Dim>::share(const Group& group) const {
    Wide sum = own_ + load(self_->kernelSums(), group);
    for (const Term& term : terms_)
        sum += term.weight * load(term.relation->list.kernel_sum.data(), group);
    return sum / lattice_sum_;
}

template <int Dim>
[[gnu::always_inline]] inline LaneMask DensitySummation<Dim>::seesSolid(const Group& group) const {
    LaneMask sees = {};
    for (const Term& term : terms_) sees |= load(term.relation->list.kernel_sum.data(), group) > 0;
    return sees;
}

/// Particles that lack support tell their neighbors.
template <int Dim>
void DensitySummation<Dim>::findInside() {
    lacks_.assign(self_->slots() + 3, 0);  // anyOf() reads beyond the last
    cut_off_.assign(self_->slots(), 0);
    parallelForGroups(body_->size(), [&](const Group& group) {
        const LaneMask lacks = share(group) < least_share_;
        for (std::size_t k = 0; k < group.count; ++k)
            lacks_[self_->slotsOf()[group.first + k]] = lacks[k] != 0;
    });
    for (Index slot = self_->firstCopy(); slot < self_->slots(); ++slot) {
        const Index original = self_->original(slot);
        lacks_[slot] = original != PairTiles<Dim>::none && lacks_[original] != 0;
    }
    const auto tell = [&](Index slot) {  // several threads may say the same
        std::atomic_ref(cut_off_[slot]).store(1, std::memory_order_relaxed);
    };
    self_->forEachCluster(
        [&](Index first, const std::uint32_t* j, std::size_t count, auto&& pairs) {
            const std::uint8_t* i_lacks = lacks_.data() + first;
            const bool any_i = (i_lacks[0] | i_lacks[1] | i_lacks[2] | i_lacks[3]) != 0;
            if (!any_i && !anyOf(lacks_.data(), j, count)) return;
            // Lane 4 i + j is the pair of i and j.
            unsigned of_lacking_i = 0;
            for (int k = 0; k < tile_side; ++k)
                if (i_lacks[k] != 0) of_lacking_i |= 0xfu << (tile_side * k);
            unsigned i_told = 0;  // lanes
            for (std::size_t tile = 0; tile_side * tile < count; ++tile, j += tile_side) {
                const unsigned of_lacking_j = lacks_[j[0]] * 0x1111u | lacks_[j[1]] * 0x2222u |
                                              lacks_[j[2]] * 0x4444u | lacks_[j[3]] * 0x8888u;
                if ((of_lacking_i | of_lacking_j) == 0) continue;
                const unsigned all = pairs(tile);
                i_told |= all & of_lacking_j;
                const unsigned j_told = all & of_lacking_i;
                if (j_told == 0) continue;
                for (int k = 0; k < tile_side; ++k)
                    if ((j_told & (0x1111u << k)) != 0) tell(j[k]);
            }
            for (int k = 0; k < tile_side; ++k)
                if ((i_told & (0xfu << (tile_side * k))) != 0) tell(first + static_cast<Index>(k));
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
